// Has a body the size of an organ, and if not, in which unit did its author probably write it?
#pragma once

#include <string>

#include "geometry/aabb.h"

namespace resect {

// Could a body of that size, in metres, be an organ: longest side of 0.02 to 1 m?
bool isOrganSized(const Aabb& box);

// "mm", "cm" or "m": the one that brings the longest side nearest to that of a liver (0.2 m) when
// the box's numbers are taken in it. Empty for a box without size.
std::string plausibleUnit(const Aabb& box);

}  // namespace resect
