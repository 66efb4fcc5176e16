// Pass or fail, with the reason, the checks and the findings on which the verdict rests.
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
  // None if the event that is measured, such as the closing of a vessel, never happened.
  std::optional<double> value;
  std::optional<double> least, most;
  bool kept = true;
  bool counts = true;  // whether it counts for pass or fail
  std::string source;  // "limit of the task, medium", "band of the task, 5 runs"
};

// A fault of an attempt: a fact that the recording shows, an open question, and advice for the next
// attempt.
struct Deduction {
  std::string measure;         // measure that the fault concerns; "": the goal or a rule
  std::optional<double> time;  // time of the fact in the recording, s
  std::string fact, question, next;
};

struct Verdict {
  bool passed = false;
  bool graded = true;
  std::string reason;  // one sentence
  // A number from 0 to 1: 0.5 times the share of the goal that was done, plus 0.5 times the share
  // of checks that were kept. If the goal was not reached, or if a rule on instruments or undo was
  // broken, the second term is 0.
  double score = 0;
  GoalResult goal;
  std::vector<Check> checks;
  std::vector<Deduction> deductions;  // the most important first
  std::vector<std::string> good;      // sentences about what was good
};

struct Scored {
  Attempt attempt;
  std::vector<Measured> measures;  // including the goal's own measures
  TaskLevel level = TaskLevel::Medium;
  Verdict verdict;
};

// Scores the attempt; attempt.task must be given. level: if empty, the task's own level is used.
// graded: false for a familiarisation run.
Scored score(Attempt attempt, std::optional<TaskLevel> level = {}, bool graded = true);

}  // namespace resect
