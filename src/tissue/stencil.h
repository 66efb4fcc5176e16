// The 26 neighbours of a cell, their numbering and their weights.
//
// Directions are numbered so that direction d and direction 25 - d are opposite. The last 13
// directions are "forward". A bond connects two neighbouring cells. From exactly one of these
// cells, the bond leads in a forward direction. Weights come from the quartic kernel (sph/kernel.h)
// with h = 0.8 spacings. The radius of the kernel is 2 spacings. The 26 neighbours are exactly the
// cells whose distance is smaller than this radius. A weight depends only on whether the neighbour
// shares a face, an edge or a corner with the cell.
#pragma once

#include <array>
#include <cstdint>

#include "base/vec.h"

namespace resect {

inline constexpr int kDirections = 26;
inline constexpr int kFirstForward = 13;
inline constexpr std::uint32_t kAllBonds = (1u << kDirections) - 1;

// Offset along an axis of the neighbour in direction d: -1, 0 or 1. Directions are ordered with x
// fastest.
constexpr int offsetAlong(int d, int axis) {
  const int place = d < kFirstForward ? d : d + 1;  // 0 to 26; 13 is the cell itself
  return axis == 0 ? place % 3 - 1 : axis == 1 ? place / 3 % 3 - 1 : place / 9 - 1;
}
constexpr int opposite(int d) { return kDirections - 1 - d; }

// 1 for a face neighbour, 2 for an edge neighbour, 3 for a corner neighbour. The number is also the
// squared distance of the neighbour, in squared spacings.
constexpr int neighbourKind(int d) {
  const int x = offsetAlong(d, 0), y = offsetAlong(d, 1), z = offsetAlong(d, 2);
  return x * x + y * y + z * z;
}

inline Vec3i offsetOf(int d) { return {offsetAlong(d, 0), offsetAlong(d, 1), offsetAlong(d, 2)}; }

// The direction of an offset with coordinates -1, 0 or 1, not all 0.
inline int directionTo(const Vec3i& offset) {
  const int place = offset.x() + 1 + 3 * (offset.y() + 1) + 9 * (offset.z() + 1);
  return place > kFirstForward ? place - 1 : place;
}

// The weights of neighbours: -V W'(r) / r times the squared spacing. The index is neighbourKind(),
// 1 to 3; element 0 is not used. V is the volume of a cell, W is the kernel, and r is the distance
// of the neighbour.
std::array<double, 4> bondWeights();

}  // namespace resect
