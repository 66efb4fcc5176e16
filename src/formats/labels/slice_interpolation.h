// Replaces the thick slices of a label by thin slices. In each of two neighbouring thick slices,
// every voxel gets its signed distance from the border of the label. These distances are
// interpolated between the two slices, and the interpolated border is where they are zero
// ("shape-based interpolation", Raya and Udupa 1990, 10.1109/42.52980).
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace resect {

// Says for each voxel whether it belongs to a label. The first axis varies fastest.
struct Mask {
  Vec3i dims = Vec3i::Zero();
  std::vector<std::uint8_t> inside;  // for each voxel: 1 if it belongs to the label, else 0

  std::size_t index(int x, int y, int z) const {
    return (std::size_t(z) * std::size_t(dims.y()) + std::size_t(y)) * std::size_t(dims.x()) +
           std::size_t(x);
  }
};

// Divides each voxel into `parts` >= 1 thinner voxels along `axis`. spacing: side lengths of the
// voxels of `mask`, in any unit. If a slice has inside voxels and the next slice has none, the
// label ends between the two slices. It reaches halfway to the empty slice at the voxel that lies
// deepest inside the label. At the other voxels it reaches less far.
Mask withThinSlices(const Mask& mask, const Vec3& spacing, int axis, int parts);

}  // namespace resect
