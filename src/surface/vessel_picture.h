// The vessels inside an organ, for viewers: a grid of bins over the tissue at rest, with the
// vessels that pass through each.
#pragma once

#include <array>
#include <vector>

#include "base/vec.h"

namespace resect {

struct VesselPicture {
  // Bin (0, 0, 0) begins at `low`; x fastest; m.
  Vec3f low = Vec3f::Zero();
  float bin = 0.005f;
  Vec3i dims = Vec3i::Zero();
  // Of each bin: its first entry, and how many there are.
  std::vector<std::array<float, 2>> bins;
  // Start and radius, end and kind (VesselKind) of a segment; m.
  std::vector<std::array<float, 8>> entries;
};

}  // namespace resect
