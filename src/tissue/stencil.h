// The 26 neighbours of a cell, their numbering and their weights.
//
// The 26 cells round a cell, numbered so that direction d and direction 25 - d are opposite; the
// last 13 are "forward": each bond is forward as seen from one of its two ends. Weights are those
// of the quartic kernel (sph/kernel.h) with h = 0.8 spacings, whose radius of 2 spacings,
// exclusive, contains exactly these cells; they depend only on whether the neighbour is a face,
// edge or corner neighbour.
#pragma once

#include <array>
#include <cstdint>

#include "base/vec.h"

namespace resect {

inline constexpr int kDirections = 26;
inline constexpr int kFirstForward = 13;
inline constexpr std::uint32_t kAllBonds = (1u << kDirections) - 1;

// Cell offset of direction d along an axis, -1, 0 or 1; x fastest.
constexpr int offsetAlong(int d, int axis) {
  const int place = d < kFirstForward ? d : d + 1;  // 13 is the cell itself
  return axis == 0 ? place % 3 - 1 : axis == 1 ? place / 3 % 3 - 1 : place / 9 - 1;
}
constexpr int opposite(int d) { return kDirections - 1 - d; }

// 1 for a face, 2 for an edge, 3 for a corner neighbour: also the squared distance in spacings.
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

// -V W'(r) / r times the squared spacing, by kind of neighbour: index 1, 2, 3; index 0 is not used.
std::array<double, 4> bondWeights();

}  // namespace resect
