// Wounds that an organ has before the operation begins.
#pragma once

#include <span>

#include "operation/scenario.h"

namespace resect {

// Cuts the organ, which must not have moved yet, and the vessels there. Throws Error if a wound
// meets no tissue.
void makeWounds(std::span<const OrganWound> wounds, OperatedOrgan& organ);

}  // namespace resect
