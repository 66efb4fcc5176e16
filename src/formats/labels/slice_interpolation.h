// Interpolates thin slices of a label between thick ones: between two slices, the border of the
// label is found from the distances to its borders in the two slices ("shape-based interpolation",
// Raya and Udupa 1990, 10.1109/42.52980).
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace resect {

// Says for each voxel whether it belongs to a label. The first axis varies fastest.
struct Mask {
  Vec3i dims = Vec3i::Zero();
  std::vector<std::uint8_t> inside;  // 0 or 1

  std::size_t index(int x, int y, int z) const {
    return (std::size_t(z) * std::size_t(dims.y()) + std::size_t(y)) * std::size_t(dims.x()) +
           std::size_t(x);
  }
};

// Divides each voxel into `parts` >= 1 along `axis`. spacing: side lengths of the voxels of `mask`,
// in any unit. If a slice has inside voxels and the next slice has none, the body ends between the
// two: it reaches halfway to the empty slice at the voxel that lies deepest inside, and less far
// elsewhere.
Mask withThinSlices(const Mask& mask, const Vec3& spacing, int axis, int parts);

}  // namespace resect
