// The result of the goal to follow a line, and the distance of the work from a line or plane.
#pragma once

#include <string>

#include "skills/score/goal_result.h"

namespace resect {

// Distance of the instrument from the goal's line or plane while the instrument works. mean, most:
// mean and largest distance, m. time: time of the largest distance, s.
struct OffLine {
  double mean = 0, most = 0, time = 0;
};
OffLine offLine(const Attempt& attempt);

// How well the line was followed. goal: the goal of attempt.task.
GoalResult followResult(const Attempt& attempt, const TaskGoal& goal);

// How near to the line the instrument must stay, as text, such as "no farther than 8 mm from it".
// The text names two distances if the limit for 90 % of the line (kLineFollowed) is stricter than
// the limit for the rest.
std::string nearText(const Task& task);

}  // namespace resect
