// Interpolates thin slices of a label between thick ones: the border between two slices is found
// from the distances to the borders in both ("shape-based interpolation", Raya and Udupa 1990,
// 10.1109/42.52980).
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace resect {

// For each voxel whether it belongs to a label; the first axis fastest.
struct Mask {
  Vec3i dims = Vec3i::Zero();
  std::vector<std::uint8_t> inside;  // 0 or 1

  std::size_t index(int x, int y, int z) const {
    return (std::size_t(z) * std::size_t(dims.y()) + std::size_t(y)) * std::size_t(dims.x()) +
           std::size_t(x);
  }
};

// Divides each voxel into `parts` >= 1 along `axis`. spacing: lengths of the voxels of `mask`.
// Beside a slice without any inside voxel, the body ends between the slices: where it is thickest
// it reaches halfway to the empty slice.
Mask withThinSlices(const Mask& mask, const Vec3& spacing, int axis, int parts);

}  // namespace resect
