// Distance from a point to a triangle.
#pragma once

#include "base/vec.h"

namespace resect {

// Squared distance of p from the triangle a, b, c, m^2. The nearest feature (corner, edge or
// interior) follows from where p projects to in the triangle's plane (Ericson 2005, section 5.1.5).
// May be NaN for a triangle without area.
double squaredDistance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace resect
