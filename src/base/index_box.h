// A box of grid points, numbered densely: a window into a grid that is too large to store a value
// for every point.
#pragma once

#include <cstdint>
#include <span>

#include "base/vec.h"

namespace resect {

struct IndexBox {
  Vec3i low = Vec3i::Zero(), dims = Vec3i::Zero();  // first point; points along each axis, >= 0

  std::size_t count() const { return std::size_t(dims.cast<std::int64_t>().prod()); }
  bool contains(const Vec3i& point) const {
    return (point.array() >= low.array()).all() && (point.array() < (low + dims).array()).all();
  }
  IndexBox widened(int margin) const {  // by `margin` points on every side
    return {low - Vec3i::Constant(margin), dims + Vec3i::Constant(2 * margin)};
  }
  // Indices run along x first; the box must hold fewer than 2^31 points.
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

// The smallest box that holds all these points. There must be at least one point.
inline IndexBox boxRound(std::span<const Vec3i> points) {
  Vec3i low = points[0], high = low;
  for (const Vec3i& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return {low, high - low + Vec3i::Ones()};
}

}  // namespace resect
