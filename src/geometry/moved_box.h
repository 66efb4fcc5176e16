// Which box holds another one that stands in a pose?
#pragma once

#include "geometry/aabb.h"
#include "geometry/pose.h"

namespace resect {

inline Aabb movedBox(const Aabb& box, const Pose& pose) {
  Aabb result;
  for (int corner = 0; corner < 8; ++corner)
    result.grow(pose * Vec3(corner & 1 ? box.max.x() : box.min.x(),
                            corner & 2 ? box.max.y() : box.min.y(),
                            corner & 4 ? box.max.z() : box.min.z()));
  return result;
}

}  // namespace resect
