// Thickness of the blood on an organ over the lattice of its cells at rest, for viewers.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/aabb.h"

namespace resect {

struct BloodMap {
  static constexpr float kDeepest = 2e-3f;  // m: what the byte 255 stands for; more counts as this

  // Texel (0, 0, 0) is at `low`, the next ones `spacing` apart, x fastest; m. Two bytes each:
  // liquid and clotted blood. Places without skin have the mean of the skin beside them.
  Vec3f low = Vec3f::Zero();
  float spacing = 1;
  Vec3i dims = Vec3i::Zero();
  std::vector<std::uint8_t> texels;
  Aabb box;  // round all blood, world, m
};

}  // namespace resect
