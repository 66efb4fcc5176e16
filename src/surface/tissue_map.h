// A map over an organ's tissue at rest, for viewers: a grid of texels with two bytes each. There
// are three kinds of map: of blood on the tissue, of damage by heat, and of structures in the
// organ, such as tumours.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/aabb.h"

namespace resect {

struct TissueMap {
  static constexpr float kDeepest = 2e-3f;  // m: blood of this thickness or more has the value 255

  // low: position of texel (0, 0, 0) in rest space, m. spacing: distance of neighbouring texels, m.
  // Texels are stored with x fastest. The two bytes of a texel are:
  // - In a map of blood: the thickness of liquid blood, and the thickness of clotted blood. Each is
  //   a weighted mean over the organ's surface in and near the texel. 255 stands for kDeepest.
  // - In a map of heat: the share of the tissue that is coagulated, and the degree of burning. This
  //   degree is 0.4 times the share of the tissue's water that has boiled off, plus 0.6 times the
  //   share of the tissue that is charred. 255 stands for 1.
  // - In a map of structures: the share of the tissue that belongs to a tumour, and the share that
  //   belongs to other structures. 255 stands for 1.
  Vec3f low = Vec3f::Zero();
  Vec3f spacing = Vec3f::Ones();
  Vec3i dims = Vec3i::Zero();
  std::vector<std::uint8_t> texels;  // empty: there is nothing to show
  // For blood and heat: a box round the present positions of the affected tissue, world, m.
  Aabb box;
};

}  // namespace resect
