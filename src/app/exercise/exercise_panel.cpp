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
#include "app/language/words.h"
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
void setAmount(QLabel* label, const QString& name, double value, std::optional<double> most,
               const char* unit, int digits) {
  const QString now = QString::number(value, 'f', digits);
  const QString whole =
      most ? Words::tr("%1: %2 of %3 %4").arg(name, now, QString::number(*most, 'g', 4), unit)
           : QString("%1: %2 %3").arg(name, now, unit);
  if (label->text() != whole) label->setText(whole);
  const QString style = most && value > *most ? colourOf(Keeping::Wrong) : "";
  if (label->styleSheet() != style) label->setStyleSheet(style);
}

}  // namespace

QLabel* ExercisePanel::addLine(const QString& name) {
  auto* label = new QLabel(this);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  label->setAccessibleName(name);
  column_->addWidget(label);
  return label;
}

ExercisePanel::ExercisePanel(QWidget* parent) : QWidget(parent), column_(new QVBoxLayout(this)) {
  column_->setSpacing(4);
  title_ = addLine(Words::tr("Title of the exercise"));
  QFont bold = title_->font();
  bold.setBold(true);
  title_->setFont(bold);
  goal_ = addLine(Words::tr("Goal"));
  steps_ = addLine(Words::tr("Steps"));
  next_ = addLine(Words::tr("Next step"));
  next_->setForegroundRole(QPalette::Link);
  time_ = addLine(Words::tr("Time"));
  blood_ = addLine(Words::tr("Blood"));
  bleeding_ = addLine(Words::tr("Time of bleeding"));
  force_ = addLine(Words::tr("Largest force"));
  distance_ = addLine(Words::tr("Distance"));
  end_ = addLine(Words::tr("End of the exercise"));
  const auto check = [&](const QString& text, const QString& tip) {
    auto* made = new QCheckBox(text, this);
    made->setToolTip(tip);
    made->setFocusPolicy(Qt::TabFocus);
    column_->addWidget(made);
    return made;
  };
  guidance_ = check(Words::tr("Guidance"),
                    Words::tr("Marks of the goal in the picture, and the next step"));
  ghosts_ = check(Words::tr("Ghost of the reference"),
                  Words::tr("What a good operator does, again and again"));
  scoring_ = new QProgressBar(this);
  scoring_->setRange(0, 0);
  scoring_->setToolTip(Words::tr("The recording is played and scored"));
  column_->addWidget(scoring_);
  auto* buttons = new QGridLayout;
  const auto button = [&](const QString& text, const QString& tip, int row, int at, auto act) {
    auto* made = new QPushButton(text, this);
    made->setToolTip(tip);
    made->setFocusPolicy(Qt::TabFocus);
    connect(made, &QPushButton::clicked, this, act);
    buttons->addWidget(made, row, at);
    return made;
  };
  finish_ = button(Words::tr("Finish"), Words::tr("Ends the attempt; it is recorded and scored"), 0,
                   0, [this] { finished(); });
  page_ = button(Words::tr("Open the report"), Words::tr("The whole debrief, in the browser"), 0, 0,
                 [this] { pageWanted(); });
  button(Words::tr("Again"), Words::tr("The same exercise from its start"), 0, 1,
         [this] { restarted(); });
  button(Words::tr("All exercises"), Words::tr("The list of exercises; this one waits"), 1, 0,
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
  nextExercise_->setText(draft ? Words::tr("Back to the maker") : Words::tr("Next exercise"));
  nextExercise_->setToolTip(draft ? Words::tr("Changes and saves this exercise")
                                  : Words::tr("The one after this, at the same level"));
  clearResult();
  title_->setText(QString("%1 (%2)").arg(title, translated(std::string(wordOf(task.level)))));
  goal_->setText(translated(goalSentence(task), kLongestSentence));
  QStringList steps;
  for (const std::string& step : task.steps)
    steps << QString("%1. %2").arg(steps.size() + 1).arg(translated(step, kLongestSentence));
  steps_->setText(steps.join('\n'));
  steps_->setVisible(guided && !steps.isEmpty());
  next_->setText(Words::tr("Read the goal, then take an instrument."));
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
  const QString next = translated(progress.next, kLongestSentence);
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
  const QString from =
      task_.goal.kind == TaskGoal::Kind::Follow     ? Words::tr("From the line: %1 mm")
      : task_.goal.kind == TaskGoal::Kind::Transect ? Words::tr("From the plane: %1 mm")
      : task_.goal.kind == TaskGoal::Kind::Resect   ? Words::tr("From the structure: %1 mm")
                                                    : Words::tr("From the target: %1 mm");
  distance_->setText(from.arg(1e3 * *distance, 0, 'f', 0));
  if (distance_->styleSheet() != colourOf(keeping)) distance_->setStyleSheet(colourOf(keeping));
}

void ExercisePanel::showAmounts(std::optional<double> seconds, std::optional<double> blood,
                                std::optional<double> force, std::optional<double> bleeding) {
  if (seconds) setAmount(time_, Words::tr("Time"), *seconds, mostOf(task_, "total_time_s"), "s", 0);
  if (blood)
    setAmount(blood_, Words::tr("Blood lost"), *blood, mostOf(task_, "blood_loss_ml"), "ml", 1);
  if (force)
    setAmount(force_, Words::tr("Largest force"), *force, mostOf(task_, "force_peak_n"), "N", 1);
  const std::optional<double> longest = mostOf(task_, "bleeding_s");
  bleeding_->setVisible(bleeding && longest);
  if (bleeding && longest)
    setAmount(bleeding_, Words::tr("Bleeding for"), *bleeding, longest, "s", 0);
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
  end_->setText(Words::tr("%1 The attempt is being scored ...").arg(why));
  end_->show();
  scoring_->show();
}

// A point that is to be changed; where the recording shows it, a button.
void ExercisePanel::addEvidence(const Evidence& one, const QString& number) {
  auto* item = one.time ? static_cast<QWidget*>(new QPushButton(this)) : new QWidget(this);
  auto* inside = new QVBoxLayout(item);
  inside->setContentsMargins(8, 4, 4, 4);
  const QString fact = translated(one.fact, kLongestSentence),
                next = translated(one.next, kLongestSentence);
  const QString when = one.time ? clockText(*one.time) + "  " : QString();
  for (const QString& text : {number + when + fact, next}) {
    if (text.isEmpty()) continue;
    auto* label = new QLabel(text, item);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setAttribute(Qt::WA_TransparentForMouseEvents);
    if (text == next) label->setForegroundRole(QPalette::PlaceholderText);
    inside->addWidget(label);
  }
  item->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::MinimumExpanding);
  if (auto* button = qobject_cast<QPushButton*>(item)) {
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(number + fact);
    button->setToolTip(Words::tr("Shows this moment again"));
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
  end_->setText(
      result.graded
          ? (result.passed ? Words::tr("Passed, %1 %") : Words::tr("Not passed, %1 %")).arg(percent)
          : (result.passed ? Words::tr("Your first attempt is for practice and does not count. It "
                                       "reached %1 %, and would have passed.")
                           : Words::tr("Your first attempt is for practice and does not count. It "
                                       "reached %1 %, and would not have passed."))
                .arg(percent));
  end_->setStyleSheet(!result.graded  ? bold
                      : result.passed ? "font-weight: bold; color: #35b36b"
                                      : "font-weight: bold; color: #f0603c");
  showAmounts(valueOf(result.measures, "total_time_s"), valueOf(result.measures, "blood_loss_ml"),
              valueOf(result.measures, "force_peak_n"), valueOf(result.measures, "bleeding_s"));
  const bool told = std::ranges::any_of(
      result.evidence, [&](const Evidence& one) { return one.fact == result.reason; });
  if (!told) add(translated(result.reason, kLongestSentence));
  if (!result.evidence.empty()) add(Words::tr("What to change"), bold);
  for (std::size_t i = 0; i < result.evidence.size(); ++i)
    addEvidence(result.evidence[i], QString("%1.  ").arg(i + 1));
  QStringList good = result.good;
  good.removeAll(result.reason);
  if (!good.isEmpty()) add(Words::tr("What was good"), bold);
  for (const QString& one : good) add(translated(one, kLongestSentence));
  scoring_->hide();
  nextExercise_->show();
  page_->show();
  page_->setEnabled(false);
  page_->setText(Words::tr("Report being written ..."));
  page_->setToolTip(Words::tr("The debrief with its pictures takes about as long as the attempt"));
}

void ExercisePanel::showPage() {
  page_->setEnabled(true);
  page_->setText(Words::tr("Open the report"));
  page_->setToolTip(Words::tr("The whole debrief, in the browser"));
}

void ExercisePanel::showFailure(const QString& sentence) {
  scoring_->hide();
  end_->setText(sentence);
  nextExercise_->show();
}

}  // namespace resect
