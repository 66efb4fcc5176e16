// Signed distance to a rigid body, from a precomputed grid. Also gives the direction in which the
// distance grows.
//
// A regular grid in the body's frame holds the distance to a closed mesh. Inside the mesh the
// distance is negative. At grid nodes within one and a half cells of the surface the distance is
// exact. Farther away the distance is approximate: the nearest triangles are propagated from node
// to node, after Danielsson 1980. Between nodes the distance is interpolated trilinearly. If a body
// is thinner than a cell of the grid, the distance is small inside the body, but not negative
// everywhere.
#pragma once

#include <vector>

#include "geometry/aabb.h"
#include "geometry/triangle_mesh.h"

namespace resect {

class SignedDistance {
 public:
  static constexpr double kFar = 1e3;  // m

  // `margin` > 0, m: how far the grid extends beyond the mesh. `cell` > 0, m: side of the grid's
  // cells. The side is enlarged if the grid would have more than 2 million nodes. For an empty mesh
  // every distance is kFar. band, m: at nodes farther than this from the mesh, the distance is not
  // computed. At these nodes the distance is set to `band` outside the body and to -`band` inside,
  // and the direction is undefined. For large thin bodies this saves most of the computing time.
  SignedDistance(const TriangleMesh& mesh, double margin, double cell, double band = kFar);

  struct Sample {
    double distance;  // m; negative inside the body; kFar outside the grid
    Vec3 outwards;    // unit, towards growing distance; zero if undefined or outside the grid
  };
  Sample operator()(const Vec3& point) const;  // point: in the body's frame, m

  const Aabb& box() const { return box_; }  // of the mesh, without margin
  double cell() const { return cell_; }     // side of the grid's cells, m

 private:
  Vec3 node(const Vec3i& at) const { return origin_ + cell_ * at.cast<double>(); }
  std::size_t index(const Vec3i& at) const {
    return (std::size_t(at.z()) * dims_.y() + at.y()) * dims_.x() + at.x();
  }

  Aabb box_;
  Vec3 origin_ = Vec3::Zero();
  Vec3i dims_ = Vec3i::Zero();
  double cell_;
  std::vector<float> distance_;
};

}  // namespace resect
