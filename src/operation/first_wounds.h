// Wounds that an organ has before the operation begins.
#pragma once

#include <span>

#include "operation/scenario.h"

namespace resect {

// Cuts `wounds` into the organ and its vessels. The organ must not have moved yet. Throws Error if
// a wound meets no tissue.
void makeWounds(std::span<const OrganWound> wounds, OperatedOrgan& organ);

}  // namespace resect
