// Distance from a point to a triangle.
#pragma once

#include "base/vec.h"

namespace resect {

// Squared distance of the point p from the triangle with the corners a, b and c, m^2. The
// projection of p onto the triangle's plane shows whether a corner, an edge or the interior is
// nearest to p (Ericson 2005, section 5.1.5). The result may be NaN if the triangle has no area.
double squaredDistance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace resect
