// Whether an attempt reached its goal, and how well: pure functions of the attempt.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "skills/score/measures.h"

namespace resect {

struct GoalResult {
  bool reached = false;
  double done = 0;                 // share of the goal that was done, 0 to 1; 1 if it is reached
  std::string sentence;            // what was reached or missed, for people
  std::optional<double> time;      // s: when the goal was reached or was missed
  std::vector<Measured> measures;  // measures that only this goal has
  std::string missing;             // as text: parts of the line that were not followed
  std::vector<std::pair<double, double>> unfollowed;  // their begins and ends, m along it
};

// A line counts as followed if at least this share of its length was followed.
inline constexpr double kLineFollowed = 0.9;

// attempt.task must be given.
GoalResult goalResult(const Attempt& attempt);

// One sentence that says what the goal is.
std::string goalSentence(const Task& task);

}  // namespace resect
