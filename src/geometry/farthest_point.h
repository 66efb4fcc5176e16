// Finds which of many points lies farthest in a direction (a support query), for many directions.
//
// The points are divided into clusters. A query searches only the clusters whose bounding boxes
// reach far enough; the reach of a box is its largest p.dot(direction). Cost: a few passes over the
// points to build, then a pass over the boxes (at most 24^3) per query.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/aabb.h"

namespace resect {

class FarthestPoint {
 public:
  // points: at least one, fewer than 2^32; all finite.
  explicit FarthestPoint(std::span<const Vec3> points);

  // Index of the point p with the largest p.dot(direction); if several points have the same value,
  // the lowest of their indices. The result is exactly that of a loop over all points.
  std::uint32_t along(const Vec3& direction) const;

 private:
  struct Cluster {
    Aabb box;
    std::uint32_t begin, end;  // its points are the entries [begin, end) of points_
  };
  std::vector<Vec3> points_;          // sorted by cluster
  std::vector<std::uint32_t> order_;  // per entry of points_: its index before sorting
  std::vector<Cluster> clusters_;
  // Bound of the rounding error of a box's reach, m, for a direction with |x| + |y| + |z| = 1.
  double rounding_ = 0;
};

}  // namespace resect
