// Tells whether a body has the size of an organ, and guesses the unit that its author used.
#pragma once

#include <string>

#include "geometry/aabb.h"

namespace resect {

// Whether a box in metres has the size of an organ: its longest side is 0.02 to 1 m.
bool isOrganSized(const Aabb& box);

// box: in the file's own numbers. Returns the unit, "mm", "cm" or "m", in which the longest side of
// the box is nearest, by ratio, to that of a liver (0.2 m). Empty for a box without size.
std::string plausibleUnit(const Aabb& box);

}  // namespace resect
