#include "app/exercise/exercises_page.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QToolButton>
#include <algorithm>

#include "app/language/words.h"
#include "app/say.h"
#include "skills/score/goal_result.h"

namespace resect {
namespace {

constexpr int kCardWidth = 320, kPictureHeight = 180;  // pixels

// "Best: passed, 92 %, easy; 3 attempts", or that there is none. What was for practice does not
// count.
QString bestText(const std::string& scenario, const std::vector<HistoryEntry>& done) {
  int attempts = 0;
  bool practised = false;
  const ClassAttempt* best = nullptr;
  for (const HistoryEntry& entry : done) {
    if (entry.scenario != scenario) continue;
    const ClassAttempt& one = entry.attempt;
    practised = practised || !one.graded;
    if (!one.graded) continue;
    ++attempts;
    if (!best || std::pair(one.passed, one.score) > std::pair(best->passed, best->score))
      best = &one;
  }
  if (!best)
    return practised ? Words::tr("Practised; the next attempt counts") : Words::tr("Not tried yet");
  const QString tries =
      (attempts == 1 ? Words::tr("%1 attempt") : Words::tr("%1 attempts")).arg(attempts);
  return (best->passed ? Words::tr("Best: passed, %1 %, %2; %3")
                       : Words::tr("Best: not passed, %1 %, %2; %3"))
      .arg(std::lround(100 * best->score))
      .arg(translated(std::string(wordOf(best->level))), tries);
}

QLabel* line(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  return label;
}

// The picture, cut to the card's shape; without one, the title on a plain ground.
QPixmap pictureOf(const Exercise& exercise, const QPalette& palette) {
  QPixmap ground(kCardWidth - 24, kPictureHeight);
  ground.fill(palette.color(QPalette::AlternateBase));
  const QPixmap picture(QString::fromStdString(exercise.picture.string()));
  QPainter painter(&ground);
  if (picture.isNull()) {
    painter.setPen(palette.color(QPalette::Mid));
    painter.drawText(ground.rect(), Qt::AlignCenter | Qt::TextWordWrap, translated(exercise.title));
  } else {
    const QPixmap fit =
        picture.scaled(ground.size(), Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
    painter.drawPixmap((ground.width() - fit.width()) / 2, (ground.height() - fit.height()) / 2,
                       fit);
  }
  painter.end();
  return ground;
}

}  // namespace

ExercisesPage::ExercisesPage(QWidget* parent) : QWidget(parent) {
  setAccessibleName(Words::tr("Exercises"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 10, 16, 10);
  auto* row = new QHBoxLayout;
  auto* title = new QLabel(Words::tr("Exercises"), this);
  QFont large = title->font();
  large.setPointSizeF(1.5 * large.pointSizeF());
  large.setBold(true);
  title->setFont(large);
  row->addWidget(title);
  row->addSpacing(20);
  row->addWidget(new QLabel(Words::tr("Learner"), this));
  learner_ = new QComboBox(this);
  learner_->setEditable(true);
  learner_->setInsertPolicy(QComboBox::NoInsert);
  learner_->setMinimumWidth(180);
  learner_->setAccessibleName(Words::tr("Learner"));
  learner_->setToolTip(Words::tr("A name or a pseudonym: attempts and results are kept under it"));
  connect(learner_, &QComboBox::textActivated, this, [this] { learnerChosen(); });
  connect(learner_->lineEdit(), &QLineEdit::editingFinished, this, [this] { learnerChosen(); });
  row->addWidget(learner_);
  test_ = new QCheckBox(Words::tr("As a test"), this);
  test_->setToolTip(
      Words::tr("Graded from the first attempt on, without guidance, and no work is taken back"));
  row->addWidget(test_);
  row->addStretch();
  const auto button = [&](const QString& text, const QString& tip, auto act) {
    auto* made = new QPushButton(text, this);
    made->setToolTip(tip);
    connect(made, &QPushButton::clicked, this, act);
    row->addWidget(made);
    return made;
  };
  auto* table =
      button(Words::tr("Class table"),
             Words::tr("Who passed what, and learning curves: a page for the teacher"), [] {});
  auto* menu = new QMenu(table);
  connect(menu->addAction(Words::tr("With pseudonyms")), &QAction::triggered, this,
          [this] { classWanted(false); });
  connect(menu->addAction(Words::tr("With the learners' names")), &QAction::triggered, this,
          [this] { classWanted(true); });
  table->setMenu(menu);
  button(Words::tr("Add ..."), Words::tr("An exercise that somebody else has made (.toml)"),
         [this] { addWanted(); });
  button(Words::tr("Make one"),
         Words::tr("An exercise from what is on the screen: mark places on the organ"),
         [this] { makeWanted(); });
  button(Words::tr("Close"), Words::tr("Back to the organ"), [this] { closed(); });
  column->addLayout(row);

  scroll_ = new QScrollArea(this);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setWidgetResizable(true);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  inside_ = new QWidget;
  grid_ = new QGridLayout(inside_);
  grid_->setSpacing(14);
  grid_->setContentsMargins(0, 6, 6, 6);
  scroll_->setWidget(inside_);
  column->addWidget(scroll_, 1);

  auto* foot = new QHBoxLayout;
  folder_ = new QLabel(this);
  folder_->setTextFormat(Qt::PlainText);
  folder_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  foot->addWidget(folder_, 1);
  said_ = new QLabel(this);
  said_->setTextFormat(Qt::PlainText);
  foot->addWidget(said_);
  auto* change = new QPushButton(Words::tr("Change folder ..."), this);
  change->setToolTip(Words::tr("Where attempts are kept, such as a folder that a class shares"));
  connect(change, &QPushButton::clicked, this, [this] { folderWanted(); });
  foot->addWidget(change);
  column->addLayout(foot);
  hide();
}

QString ExercisesPage::learner() const { return learner_->currentText(); }
bool ExercisesPage::asTest() const { return test_->isChecked(); }
void ExercisesPage::say(const QString& sentence) { said_->setText(sentence); }

QWidget* ExercisesPage::makeCard(const Exercise& exercise, const std::vector<HistoryEntry>& done) {
  auto* card = new QFrame(inside_);
  card->setFrameShape(QFrame::StyledPanel);
  card->setAutoFillBackground(true);
  card->setBackgroundRole(QPalette::Base);
  card->setFixedWidth(kCardWidth);
  auto* column = new QVBoxLayout(card);
  auto* picture = new QLabel(card);
  picture->setPixmap(pictureOf(exercise, QApplication::palette()));
  picture->setAccessibleName(Words::tr("Picture of %1").arg(translated(exercise.title)));
  column->addWidget(picture);
  QLabel* title = line(translated(exercise.title), card);
  QFont bold = title->font();
  bold.setBold(true);
  bold.setPointSizeF(1.1 * bold.pointSizeF());
  title->setFont(bold);
  column->addWidget(title);
  column->addWidget(line(translated(exercise.task.teaches, kLongestSentence), card));
  column->addWidget(line(translated(goalSentence(exercise.task), kLongestSentence), card));
  column->addStretch();
  QLabel* best = line(bestText(exercise.name, done), card);
  best->setForegroundRole(QPalette::Link);
  column->addWidget(best);
  auto* row = new QHBoxLayout;
  auto* level = new QComboBox(card);
  const QString key = "level/" + QString::fromStdString(exercise.name);  // the one chosen last
  for (const TaskLevel one : kTaskLevels)
    level->addItem(translated(std::string(wordOf(one))), int(one));
  level->setCurrentIndex(QSettings().value(key, int(exercise.task.level)).toInt());
  level->setAccessibleName(Words::tr("Level of %1").arg(translated(exercise.title)));
  level->setToolTip(
      Words::tr("Easy, medium: guidance is shown; hard: none. Limits differ by level"));
  connect(level, &QComboBox::currentIndexChanged, this,
          [key](int i) { QSettings().setValue(key, i); });
  row->addWidget(level);
  auto* about = new QPushButton(Words::tr("About"), card);
  about->setAccessibleName(Words::tr("About %1").arg(translated(exercise.title)));
  about->setToolTip(
      Words::tr("What this exercise teaches, its limits, and what studies have measured: a page"));
  connect(about, &QPushButton::clicked, this, [this, exercise] { aboutWanted(exercise); });
  row->addWidget(about);
  row->addStretch();
  auto* start = new QPushButton(Words::tr("Start"), card);
  start->setAccessibleName(Words::tr("Start %1").arg(translated(exercise.title)));
  start->setDefault(true);
  connect(start, &QPushButton::clicked, this,
          [this, exercise, level] { started(exercise, TaskLevel(level->currentData().toInt())); });
  row->addWidget(start);
  column->addLayout(row);
  return card;
}

void ExercisesPage::show(const std::vector<Exercise>& exercises,
                         const std::vector<HistoryEntry>& done, const QStringList& learners,
                         const QString& learner, const QString& folder) {
  {
    const QSignalBlocker quiet(learner_), edit(learner_->lineEdit());
    learner_->clear();
    learner_->addItems(learners);
    learner_->setCurrentText(learner);
  }
  folder_->setText(
      Words::tr("Attempts are kept in %1").arg(shown(folder.toStdString(), kLongestShownPath)));
  for (QWidget* card : cards_) card->deleteLater();
  cards_.clear();
  for (const Exercise& exercise : exercises) cards_.push_back(makeCard(exercise, done));
  columns_ = 0;
  placeCards();
  QWidget::show();
  raise();
}

void ExercisesPage::placeCards() {
  const int room = width() - 60;
  const int columns = std::max(1, room / (kCardWidth + grid_->horizontalSpacing()));
  if (columns == columns_) return;
  columns_ = columns;
  for (std::size_t i = 0; i < cards_.size(); ++i)
    grid_->addWidget(cards_[i], int(i) / columns, int(i) % columns);
  for (int c = 0; c < grid_->columnCount(); ++c) grid_->setColumnStretch(c, 0);
  grid_->setColumnStretch(columns, 1);
  grid_->setRowStretch(int(cards_.size()) / columns + 1, 1);
}

void ExercisesPage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  placeCards();
}

void ExercisesPage::paintEvent(QPaintEvent*) {
  QPainter(this).fillRect(rect(), palette().color(QPalette::Window));
}

}  // namespace resect
