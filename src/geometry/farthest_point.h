// The farthest of many points in a direction (a support query), for many directions.
//
// Points are clustered; a query looks only into clusters whose boxes reach far enough. Cost: two
// passes over the points to build, then a pass over some thousand boxes per query.
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

  // Index of the point with the largest p.dot(direction), the first of equals: exactly what a loop
  // over all points finds.
  std::uint32_t along(const Vec3& direction) const;

 private:
  struct Cluster {
    Aabb box;
    std::uint32_t begin, end;  // in points_
  };
  std::vector<Vec3> points_;          // sorted by cluster
  std::vector<std::uint32_t> order_;  // their original indices
  std::vector<Cluster> clusters_;
  double rounding_ = 0;  // bound of the rounding error of a box's reach, for unit directions
};

}  // namespace resect
