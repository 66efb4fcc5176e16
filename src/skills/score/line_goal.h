// The goal of following a line, and how far work went from a line or plane.
#pragma once

#include <string>

#include "skills/score/goal_result.h"

namespace resect {

// Mean and largest distance of the work from line or plane, m, and when it was largest, s.
struct OffLine {
  double mean = 0, most = 0, time = 0;
};
OffLine offLine(const Attempt& attempt);

// How the line was followed: `goal` is the goal of attempt.task.
GoalResult followResult(const Attempt& attempt, const TaskGoal& goal);

// "no farther than 8 mm from it", or that the strip and the farthest place differ.
std::string nearText(const Task& task);

}  // namespace resect
