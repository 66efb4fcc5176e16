// The next step of an attempt in progress.
#pragma once

#include <string>

#include "skills/score/goal_result.h"

namespace resect {

// One sentence that says what to do next. goal: goalResult(attempt).
std::string nextStep(const Attempt& attempt, const GoalResult& goal);

// Number, from 0, of the target to be touched next. If all targets have been touched, the number of
// targets.
std::size_t nextTarget(const GoalResult& goal);

}  // namespace resect
