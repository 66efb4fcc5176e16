// Distance from a point to a triangle.
#pragma once

#include "base/vec.h"

namespace resect {

// Squared distance of p from the triangle a, b, c, m^2. The projection of p onto the triangle's
// plane decides whether a corner, an edge or the interior is nearest (Ericson 2005, section 5.1.5).
// May be NaN for a triangle without area.
double squaredDistance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace resect
