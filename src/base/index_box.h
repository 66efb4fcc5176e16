// A box of grid points, which are numbered consecutively. The box is used to store values for a
// part of a grid if values for the whole grid would take too much memory.
#pragma once

#include <cstdint>
#include <span>

#include "base/vec.h"

namespace resect {

struct IndexBox {
  // low: the lowest point of the box. dims: number of points along each axis, >= 0.
  Vec3i low = Vec3i::Zero(), dims = Vec3i::Zero();

  std::size_t count() const { return std::size_t(dims.cast<std::int64_t>().prod()); }
  bool contains(const Vec3i& point) const {
    return (point.array() >= low.array()).all() && (point.array() < (low + dims).array()).all();
  }
  IndexBox widened(int margin) const {  // larger by `margin` points on every side
    return {low - Vec3i::Constant(margin), dims + Vec3i::Constant(2 * margin)};
  }
  // Points are numbered from 0, x fastest. The box must hold fewer than 2^31 points. step():
  // difference between the indices of two points that are neighbours along the axis. index(): index
  // of a point, which must lie in the box. coordinates(): the point with this index.
  std::int32_t step(int axis) const {
    return axis == 0 ? 1 : axis == 1 ? dims.x() : dims.x() * dims.y();
  }
  std::int32_t index(const Vec3i& point) const {
    const Vec3i at = point - low;
    return (at.z() * dims.y() + at.y()) * dims.x() + at.x();
  }
  Vec3i coordinates(std::int32_t index) const {
    const std::int32_t row = index / dims.x();
    return low + Vec3i(index % dims.x(), row % dims.y(), row / dims.y());
  }
};

// The smallest box that holds all the given points. There must be at least one point.
inline IndexBox boxRound(std::span<const Vec3i> points) {
  Vec3i low = points[0], high = low;
  for (const Vec3i& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return {low, high - low + Vec3i::Ones()};
}

}  // namespace resect
