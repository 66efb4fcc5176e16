// Converts vectors between Resect's and Inventor's types.
#pragma once

#include <Inventor/SbVec3f.h>

#include "base/vec.h"

namespace resect {

inline Vec3 toVec(const SbVec3f& v) { return {v[0], v[1], v[2]}; }
inline SbVec3f toSb(const Vec3& v) { return {float(v.x()), float(v.y()), float(v.z())}; }

}  // namespace resect
