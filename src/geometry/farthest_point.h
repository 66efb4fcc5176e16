// Which of many points sticks out farthest in a direction, asked for many directions?
//
// Points that lie together share a box; a question looks into the few boxes that reach so far.
// Cost: two passes over the points to build, then a pass over some thousand boxes per question.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/aabb.h"

namespace resect {

class FarthestPoint {
 public:
  // At least one point, all finite, fewer than 2^32.
  explicit FarthestPoint(std::span<const Vec3> points);

  // Number of the point with the largest p.dot(direction), the first of equals: exactly what a loop
  // over all points finds.
  std::uint32_t along(const Vec3& direction) const;

 private:
  struct Cluster {
    Aabb box;
    std::uint32_t begin, end;  // in points_
  };
  std::vector<Vec3> points_;          // those of a cluster together
  std::vector<std::uint32_t> order_;  // their numbers
  std::vector<Cluster> clusters_;
  double rounding_ = 0;  // that a box's reach may be wrong by, for directions of length 1
};

}  // namespace resect
