// Finds which of many points lies farthest in a direction (a support query), for many directions.
//
// The points are divided into clusters. A query searches only the clusters whose bounding boxes
// reach far enough. Cost: a few passes over the points to build, then a pass over some thousand
// boxes per query.
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

  // Index of the point p with the largest p.dot(direction); of several equal ones the first. A loop
  // over all points finds exactly the same.
  std::uint32_t along(const Vec3& direction) const;

 private:
  struct Cluster {
    Aabb box;
    std::uint32_t begin, end;  // in points_
  };
  std::vector<Vec3> points_;          // sorted by cluster
  std::vector<std::uint32_t> order_;  // their original indices
  std::vector<Cluster> clusters_;
  // Bound of the rounding error of a box's reach, for a direction whose |x| + |y| + |z| is 1.
  double rounding_ = 0;
};

}  // namespace resect
