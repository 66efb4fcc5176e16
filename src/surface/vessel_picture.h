// The vessels inside an organ, for viewers: a grid of cubic bins over the tissue at rest. Vessels
// consist of straight segments. Each bin lists the segments that pass through it.
#pragma once

#include <array>
#include <vector>

#include "base/vec.h"

namespace resect {

struct VesselPicture {
  // low: lowest corner of bin (0, 0, 0), rest space, m. bin: side of a bin, m. dims: number of bins
  // along each axis.
  Vec3f low = Vec3f::Zero();
  float bin = 0.005f;
  Vec3i dims = Vec3i::Zero();
  // Per bin, x fastest: the index in `entries` of its first entry, and the number of its entries.
  std::vector<std::array<float, 2>> bins;
  // Each entry describes a segment by eight numbers: x, y and z of its start, its radius, x, y and
  // z of its end, and its VesselKind as a number. Lengths are in m, positions in rest space.
  std::vector<std::array<float, 8>> entries;
};

}  // namespace resect
