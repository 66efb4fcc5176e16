// The panel of the exercise in progress: goal, next step and limits, and the result at the end.
#pragma once

#include <QWidget>
#include <functional>
#include <vector>

#include "app/exercise/attempt_scorer.h"
#include "inventor/hand/marks/guide_marks.h"
#include "operation/live/live_state.h"
#include "operation/task/task.h"
#include "skills/live/live_attempt.h"

class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace resect {

class ExercisePanel : public QWidget {
 public:
  explicit ExercisePanel(QWidget* parent = nullptr);

  // To be called when an attempt begins. guided: whether guidance may be shown. ghosts: whether the
  // exercise has a reference run, whose instruments can be shown as transparent ghosts
  // (inventor/hand/ghost_tools.h). draft: whether the user is still making the exercise.
  void begin(const QString& title, const Task& task, bool guided, bool ghosts, bool draft);
  // Shows the present figures. seconds: time of the attempt. distance: from the instrument in hand
  // to the goal's marks, m (distanceFrom() of guide_marks.h); empty if the goal has no marks now.
  // keeping: whether the instrument is near enough to the marks (keepingOf()).
  void follow(const LiveState& state, double seconds, const AttemptProgress& progress,
              std::optional<double> distance, Keeping keeping);
  // guidance(): whether to show guidance. ghosts(): whether to show ghosts. Each function returns
  // true only if the exercise offers this help and the user has switched it on.
  bool guidance() const;
  bool ghosts() const;
  QString nextStep() const;  // empty: no next step is to be shown

  // Says why the attempt is over, and that it is being scored.
  void showEnd(const QString& why);
  void showResult(const AttemptResult& result);
  void showPage();  // lets the user open the report
  void showFailure(const QString& sentence);

  std::function<void()> finished, restarted, nextWanted, pageWanted, exercisesWanted;
  std::function<void(double seconds)> evidenceChosen;

 private:
  QLabel* addLine(const QString& name);
  void clearResult();
  // seconds: time of the attempt, s. blood: blood lost, ml. force: largest force, N. bleeding:
  // duration of the bleeding, s.
  void showAmounts(std::optional<double> seconds, std::optional<double> blood,
                   std::optional<double> force, std::optional<double> bleeding);
  void addResult(QWidget* widget);
  void addEvidence(const Evidence& one, const QString& number);

  QVBoxLayout *column_, *results_;
  QLabel *title_, *goal_, *steps_, *next_, *time_, *blood_, *bleeding_, *force_, *distance_, *end_;
  QCheckBox *guidance_, *ghosts_;
  QPushButton *finish_, *nextExercise_, *page_;
  QProgressBar* scoring_;
  std::vector<QWidget*> result_;
  Task task_;
};

}  // namespace resect
