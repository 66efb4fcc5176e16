// A map over an organ's tissue at rest, for viewers: a grid of texels with two bytes each. They
// give the thickness of the blood on the tissue, its damage by heat, or the structure that it
// belongs to.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/aabb.h"

namespace resect {

struct TissueMap {
  static constexpr float kDeepest = 2e-3f;  // m: blood of this thickness or more has the value 255

  // Texel (0, 0, 0) is at `low` in rest space, the next ones `spacing` apart, x fastest; m. The two
  // bytes of a texel, in a map of blood: thickness of liquid and of clotted blood, as the weighted
  // mean over the skin at and beside the texel. In a map of heat: share of the tissue that is
  // coagulated, and share that is charred. In a map of structures: share of the tissue that is
  // tumour, and share that is any other structure. For shares, 255 means all of the tissue.
  Vec3f low = Vec3f::Zero();
  Vec3f spacing = Vec3f::Ones();
  Vec3i dims = Vec3i::Zero();
  std::vector<std::uint8_t> texels;  // empty: there is nothing to show
  Aabb box;                          // of blood, heat: bounds of what the map shows, world, m
};

}  // namespace resect
