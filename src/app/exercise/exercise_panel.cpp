#include "app/exercise/exercise_panel.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/exercise/exercise_list.h"
#include "app/say.h"
#include "app/widgets/timeline_panel.h"
#include "skills/score/goal_result.h"

namespace resect {
namespace {

const char* colourOf(Keeping keeping) {
  switch (keeping) {
    case Keeping::Far:
      return "";
    case Keeping::Well:
      return "color: #3fb4ff";
    case Keeping::Near:
      return "color: #e0b020";
    case Keeping::Wrong:
      return "color: #f0603c";
  }
  return "";
}

// "Time: 12 of 25 s", red when it is too much.
void setAmount(QLabel* label, const char* name, double value, std::optional<double> most,
               const char* unit, int digits) {
  QString text = QString("%1: %2").arg(name).arg(value, 0, 'f', digits);
  if (most) text += QString(" of %1").arg(*most, 0, 'g', 4);
  const QString whole = text + " " + unit;
  if (label->text() != whole) label->setText(whole);
  const QString style = most && value > *most ? colourOf(Keeping::Wrong) : "";
  if (label->styleSheet() != style) label->setStyleSheet(style);
}

}  // namespace

QLabel* ExercisePanel::addLine(const char* name) {
  auto* label = new QLabel(this);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  label->setAccessibleName(name);
  column_->addWidget(label);
  return label;
}

ExercisePanel::ExercisePanel(QWidget* parent) : QWidget(parent), column_(new QVBoxLayout(this)) {
  column_->setSpacing(4);
  title_ = addLine("Title of the exercise");
  QFont bold = title_->font();
  bold.setBold(true);
  title_->setFont(bold);
  goal_ = addLine("Goal");
  steps_ = addLine("Steps");
  next_ = addLine("Next step");
  next_->setForegroundRole(QPalette::Link);
  time_ = addLine("Time");
  blood_ = addLine("Blood");
  bleeding_ = addLine("Time of bleeding");
  force_ = addLine("Largest force");
  distance_ = addLine("Distance");
  end_ = addLine("End of the exercise");
  const auto check = [&](const char* text, const char* tip) {
    auto* made = new QCheckBox(text, this);
    made->setToolTip(tip);
    made->setFocusPolicy(Qt::TabFocus);
    column_->addWidget(made);
    return made;
  };
  guidance_ = check("Guidance", "Marks of the goal in the picture, and the next step");
  ghosts_ = check("Ghost of the reference", "What a good operator does, again and again");
  scoring_ = new QProgressBar(this);
  scoring_->setRange(0, 0);
  scoring_->setToolTip("The recording is played and scored");
  column_->addWidget(scoring_);
  auto* buttons = new QGridLayout;
  const auto button = [&](const char* text, const char* tip, int row, int at, auto act) {
    auto* made = new QPushButton(text, this);
    made->setToolTip(tip);
    made->setFocusPolicy(Qt::TabFocus);
    connect(made, &QPushButton::clicked, this, act);
    buttons->addWidget(made, row, at);
    return made;
  };
  finish_ =
      button("Finish", "Ends the attempt; it is recorded and scored", 0, 0, [this] { finished(); });
  page_ = button("Open the report", "The whole debrief, in the browser", 0, 0,
                 [this] { pageWanted(); });
  button("Again", "The same exercise from its start", 0, 1, [this] { restarted(); });
  button("All exercises", "The list of exercises; this one waits", 1, 0,
         [this] { exercisesWanted(); });
  nextExercise_ = button("", "", 1, 1, [this] { nextWanted(); });
  column_->addLayout(buttons);
  results_ = new QVBoxLayout;
  results_->setSpacing(4);
  column_->addLayout(results_);
  column_->addStretch();
}

void ExercisePanel::begin(const QString& title, const Task& task, bool guided, bool ghosts,
                          bool draft) {
  task_ = task;
  nextExercise_->setText(draft ? "Back to the maker" : "Next exercise");
  nextExercise_->setToolTip(draft ? "Changes and saves this exercise"
                                  : "The one after this, at the same level");
  clearResult();
  title_->setText(
      QString("%1 (%2)").arg(title, QString::fromStdString(std::string(wordOf(task.level)))));
  goal_->setText(shown(goalSentence(task), kLongestSentence));
  QStringList steps;
  for (const std::string& step : task.steps)
    steps << QString("%1. %2").arg(steps.size() + 1).arg(shown(step, kLongestSentence));
  steps_->setText(steps.join('\n'));
  steps_->setVisible(guided && !steps.isEmpty());
  next_->setText("Read the goal, then take an instrument.");
  guidance_->setVisible(guided);
  guidance_->setChecked(guided);
  ghosts_->setVisible(guided && ghosts);
  ghosts_->setChecked(guided && ghosts && task.level == TaskLevel::Easy);
  for (QWidget* one : {end_, distance_, bleeding_}) one->hide();
  next_->setVisible(guided);
  for (QWidget* one : std::initializer_list<QWidget*>{page_, nextExercise_, scoring_}) one->hide();
  finish_->show();
}

bool ExercisePanel::guidance() const { return !guidance_->isHidden() && guidance_->isChecked(); }
bool ExercisePanel::ghosts() const { return !ghosts_->isHidden() && ghosts_->isChecked(); }

QString ExercisePanel::nextStep() const {
  return guidance() && end_->isHidden() ? next_->text() : QString();
}

void ExercisePanel::follow(const LiveState& state, double seconds, const AttemptProgress& progress,
                           std::optional<double> distance, Keeping keeping) {
  const QString next = shown(progress.next, kLongestSentence);
  if (!next.isEmpty() && next_->text() != next) next_->setText(next);
  next_->setVisible(guidance());
  blood_->setVisible(state.bleeds);
  double force = 0;
  for (const double one : state.peakForces) force = std::max(force, one);
  force_->setVisible(state.moves);
  showAmounts(seconds, 1e6 * state.bled, force, progress.bleeding);
  const bool near = guidance() && distance;
  distance_->setVisible(near);
  if (!near) return;
  const char* from = task_.goal.kind == TaskGoal::Kind::Follow     ? "From the line: %1 mm"
                     : task_.goal.kind == TaskGoal::Kind::Transect ? "From the plane: %1 mm"
                     : task_.goal.kind == TaskGoal::Kind::Resect   ? "From the structure: %1 mm"
                                                                   : "From the target: %1 mm";
  distance_->setText(QString(from).arg(1e3 * *distance, 0, 'f', 0));
  if (distance_->styleSheet() != colourOf(keeping)) distance_->setStyleSheet(colourOf(keeping));
}

void ExercisePanel::showAmounts(std::optional<double> seconds, std::optional<double> blood,
                                std::optional<double> force, std::optional<double> bleeding) {
  if (seconds) setAmount(time_, "Time", *seconds, mostOf(task_, "total_time_s"), "s", 0);
  if (blood) setAmount(blood_, "Blood lost", *blood, mostOf(task_, "blood_loss_ml"), "ml", 1);
  if (force) setAmount(force_, "Largest force", *force, mostOf(task_, "force_peak_n"), "N", 1);
  const std::optional<double> longest = mostOf(task_, "bleeding_s");
  bleeding_->setVisible(bleeding && longest);
  if (bleeding && longest) setAmount(bleeding_, "Bleeding for", *bleeding, longest, "s", 0);
}

void ExercisePanel::clearResult() {
  for (QWidget* one : result_) one->deleteLater();
  result_.clear();
}

void ExercisePanel::addResult(QWidget* widget) {
  results_->addWidget(widget);
  result_.push_back(widget);
}

void ExercisePanel::showEnd(const QString& why) {
  for (QWidget* one :
       std::initializer_list<QWidget*>{finish_, guidance_, ghosts_, steps_, next_, distance_})
    one->hide();
  end_->setStyleSheet("font-weight: bold");  // no verdict yet; an earlier one had a colour
  end_->setText(why + " The attempt is being scored ...");
  end_->show();
  scoring_->show();
}

// A point that is to be changed; where the recording shows it, a button.
void ExercisePanel::addEvidence(const Evidence& one, const QString& number) {
  auto* item = one.time ? static_cast<QWidget*>(new QPushButton(this)) : new QWidget(this);
  auto* inside = new QVBoxLayout(item);
  inside->setContentsMargins(8, 4, 4, 4);
  const QString when = one.time ? clockText(*one.time) + "  " : QString();
  for (const QString& text : {number + when + one.fact, one.next}) {
    if (text.isEmpty()) continue;
    auto* label = new QLabel(text, item);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setAttribute(Qt::WA_TransparentForMouseEvents);
    if (text == one.next) label->setForegroundRole(QPalette::PlaceholderText);
    inside->addWidget(label);
  }
  item->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::MinimumExpanding);
  if (auto* button = qobject_cast<QPushButton*>(item)) {
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(number + one.fact);
    button->setToolTip("Shows this moment again");
    connect(button, &QPushButton::clicked, this,
            [this, time = *one.time] { evidenceChosen(time); });
  }
  addResult(item);
}

void ExercisePanel::showResult(const AttemptResult& result) {
  clearResult();
  const auto add = [&](const QString& text, const char* style = "") {
    auto* label = new QLabel(text, this);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setStyleSheet(style);
    addResult(label);
  };
  const char* bold = "font-weight: bold";
  const auto percent = std::lround(100 * result.score);
  end_->setText(result.graded
                    ? QString("%1, %2 %").arg(result.passed ? "Passed" : "Not passed").arg(percent)
                    : QString("Your first attempt is for practice and does not count. It reached "
                              "%1 %, and would %2.")
                          .arg(percent)
                          .arg(result.passed ? "have passed" : "not have passed"));
  end_->setStyleSheet(!result.graded  ? bold
                      : result.passed ? "font-weight: bold; color: #35b36b"
                                      : "font-weight: bold; color: #f0603c");
  showAmounts(valueOf(result.measures, "total_time_s"), valueOf(result.measures, "blood_loss_ml"),
              valueOf(result.measures, "force_peak_n"), valueOf(result.measures, "bleeding_s"));
  const bool told = std::ranges::any_of(
      result.evidence, [&](const Evidence& one) { return one.fact == result.reason; });
  if (!told) add(result.reason);
  if (!result.evidence.empty()) add("What to change", bold);
  for (std::size_t i = 0; i < result.evidence.size(); ++i)
    addEvidence(result.evidence[i], QString("%1.  ").arg(i + 1));
  QStringList good = result.good;
  good.removeAll(result.reason);
  if (!good.isEmpty()) add("What was good", bold);
  for (const QString& one : good) add(one);
  scoring_->hide();
  nextExercise_->show();
  page_->show();
  page_->setEnabled(false);
}

void ExercisePanel::showPage() { page_->setEnabled(true); }

void ExercisePanel::showFailure(const QString& sentence) {
  scoring_->hide();
  end_->setText(sentence);
  nextExercise_->show();
}

}  // namespace resect
