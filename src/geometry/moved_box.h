// The axis-aligned bounding box of a box that a pose has moved and rotated.
#pragma once

#include "geometry/aabb.h"
#include "geometry/pose.h"

namespace resect {

inline Aabb movedBox(const Aabb& box, const Pose& pose) {
  Aabb result;
  for (int i = 0; i < 8; ++i) result.grow(pose * box.corner(i));
  return result;
}

}  // namespace resect
