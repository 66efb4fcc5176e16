// Two values at each place of an organ's tissue at rest, as bytes for viewers: how thick blood lies
// on it, what heat has done to it, or which structure it belongs to.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/aabb.h"

namespace resect {

struct TissueMap {
  static constexpr float kDeepest = 2e-3f;  // m of blood that 255 stands for; more counts as this

  // Texel (0, 0, 0) is at `low`, the next ones `spacing` apart, x fastest; m. Two bytes each. Of
  // blood: liquid and clotted; places without skin have the mean of the skin beside them. Of heat:
  // coagulated and charred, 255 for wholly. Of structures: tumour, and any other structure.
  Vec3f low = Vec3f::Zero();
  Vec3f spacing = Vec3f::Ones();
  Vec3i dims = Vec3i::Zero();
  std::vector<std::uint8_t> texels;  // none: there is nothing to show
  Aabb box;                          // round all that the map shows, world, m
};

}  // namespace resect
