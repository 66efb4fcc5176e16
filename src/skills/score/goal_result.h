// Whether an attempt reached its goal, and how well: pure functions of the attempt.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "skills/score/measures.h"

namespace resect {

struct GoalResult {
  bool reached = false;
  double done = 0;                 // share of the goal that was done, 0 to 1; 1 if `reached`
  std::string sentence;            // what was reached or missed, for people
  std::optional<double> time;      // when the goal was reached or was missed, s
  std::vector<Measured> measures;  // measures that only goals of this kind have
  // For a goal with a line: the parts of the line that were not followed. missing: as text.
  // unfollowed: beginning and end of each part, as distances along the line from its beginning, m.
  std::string missing;
  std::vector<std::pair<double, double>> unfollowed;
};

// For the goal to follow a line, at least this share of the line's length must be followed.
inline constexpr double kLineFollowed = 0.9;

// attempt.task must be given.
GoalResult goalResult(const Attempt& attempt);

// One sentence that says what the goal is.
std::string goalSentence(const Task& task);

}  // namespace resect
