// What is to be done next in an attempt that goes on.
#pragma once

#include <string>

#include "skills/score/goal_result.h"

namespace resect {

// One sentence. goal: goalResult(attempt).
std::string nextStep(const Attempt& attempt, const GoalResult& goal);

// Number of the target that is to be touched next, from 0; the number of targets if all are done.
std::size_t nextTarget(const GoalResult& goal);

}  // namespace resect
