// Finds the point that lies farthest in a direction (a support query), among many points and for
// many directions.
//
// The points are divided into clusters, and each cluster has a bounding box. The reach of a box is
// the largest p.dot(direction) of a point p in it. A query first searches the cluster whose box has
// the largest reach. After that, it searches only the clusters whose boxes reach at least as far as
// the best point found. Cost of the constructor: a few passes over the points. Cost of a query: two
// passes over the boxes, of which there are at most 24^3, and the search in a few clusters.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/aabb.h"

namespace resect {

class FarthestPoint {
 public:
  // points: at least one and fewer than 2^32 points, all finite.
  explicit FarthestPoint(std::span<const Vec3> points);

  // Index of the point p with the largest p.dot(direction). If several points have this largest
  // value, the result is the lowest of their indices. A loop over all points would give exactly the
  // same result.
  std::uint32_t along(const Vec3& direction) const;

 private:
  struct Cluster {
    Aabb box;
    std::uint32_t begin, end;  // the cluster's points are points_[begin] to points_[end - 1]
  };
  std::vector<Vec3> points_;          // all points, sorted by cluster
  std::vector<std::uint32_t> order_;  // for each entry of points_: its index before sorting
  std::vector<Cluster> clusters_;
  // Upper limit of the rounding error of a box's reach, m, for a direction with |x| + |y| +
  // |z| = 1.
  double rounding_ = 0;
};

}  // namespace resect
