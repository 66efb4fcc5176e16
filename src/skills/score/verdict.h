// Pass or fail, with the reason, and what each of them rests on.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skills/attempt/attempt.h"
#include "skills/score/goal_result.h"
#include "skills/score/measures.h"

namespace resect {

// A measure that was compared with a limit or band of the task.
struct Check {
  std::string measure;
  // None: what it measures never came about, such as the closing of a vessel.
  std::optional<double> value;
  std::optional<double> least, most;
  bool kept = true;
  bool counts = true;  // for pass or fail
  std::string source;  // "limit of the task, medium", "band of the task, 5 runs"
};

// One thing that was not as wanted: a fact that the recording shows, an open question, and what to
// try next.
struct Deduction {
  std::string measure;         // that it belongs to; "": the goal or a rule
  std::optional<double> time;  // s, at which the recording shows it
  std::string fact, question, next;
};

struct Verdict {
  bool passed = false;
  bool graded = true;
  std::string reason;  // one sentence
  // 0 to 1: half of it is the share of the goal that was done; the other half, which counts only if
  // the goal was reached and no rule broken, the share of the checks that were kept.
  double score = 0;
  GoalResult goal;
  std::vector<Check> checks;
  std::vector<Deduction> deductions;  // the weightiest first
  std::vector<std::string> good;
};

struct Scored {
  Attempt attempt;
  std::vector<Measured> measures;  // those of the goal included
  TaskLevel level = TaskLevel::Medium;
  Verdict verdict;
};

// attempt.task must be given. level: empty: the task's own. graded: false for a run that is a
// familiarisation.
Scored score(Attempt attempt, std::optional<TaskLevel> level = {}, bool graded = true);

}  // namespace resect
