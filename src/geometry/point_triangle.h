// Distance from a point to a triangle.
#pragma once

#include "base/vec.h"

namespace resect {

// Squared distance of p to the triangle a, b, c, by the region of its plane that p projects into
// (Ericson 2005, section 5.1.5). NaN for a triangle without area when p projects into its interior.
double squaredDistance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace resect
