// How long is a file's unit, and which one did its author probably mean?
#pragma once

#include <string>

#include "geometry/aabb.h"

namespace resect {

// Metres in a unit given as mm, cm, m, inch or a positive number ("0.001"); a usage Error else.
double metresPerUnit(const std::string& unit);

// "mm", "cm" or "m": the one that brings the box's longest side nearest to that of a liver (0.2 m),
// when a side of 1 of the box's numbers is taken as one unit. Empty for an empty box.
std::string plausibleUnit(const Aabb& box);

// Could a body of that size, in metres, be an organ: longest side of 0.02 to 1 m?
bool isOrganSized(const Aabb& box);

}  // namespace resect
