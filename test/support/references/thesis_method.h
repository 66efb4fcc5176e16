// The thesis's method (2004) for an organ's surface, written in the obvious way: a reference to
// compare with.
//
// At each update every node of a regular grid over the organ's bounding box sums the kernel over
// all particles (equation 3.6, the profile's getLevelSet), then marching cubes visits all cells and
// makes points with gradients and triangles. Nothing is kept from one update to the next. The
// kernel is the corrected one and the triangles come from our table, so that the same nodes give
// the same surface as ours.
#pragma once

#include <span>
#include <vector>

#include "base/stage_clock.h"
#include "geometry/aabb.h"
#include "geometry/triangle_mesh.h"

namespace resect::test {

struct ThesisParticle {
  Vec3 position;  // m
  double volume;  // m^3
  double colour;  // in [0, 100]; 0 once a tool has touched it
};

// A regular grid with its first node at `min` and its last at `max`.
struct ThesisGrid {
  Aabb box;
  Vec3i nodes;  // along each axis, >= 2

  Vec3 spacing() const { return box.size().cwiseQuotient((nodes - Vec3i::Ones()).cast<double>()); }
  std::size_t count() const { return std::size_t(nodes.x()) * nodes.y() * nodes.z(); }
};

struct ThesisSurface {
  TriangleMesh mesh;
  std::vector<Vec3> normals;
};

class ThesisMethod {
 public:
  // h: smoothing length, m. iso in (0, 100).
  ThesisMethod(ThesisGrid grid, double h, double iso) : grid_(grid), h_(h), iso_(iso) {}

  // Equation 3.6 with colour values, summed over every particle wherever it is.
  double getLevelSet(std::span<const ThesisParticle> particles, const Vec3& r) const;
  // As getLevelSet, but particles beyond the kernel's support are passed over by their squared
  // distance: what a careful programmer would have done then.
  double getLevelSetNear(std::span<const ThesisParticle> particles, const Vec3& r) const;

  // One surface update: all nodes, all cells. clock: gets a lap per function, under its name.
  ThesisSurface update(std::span<const ThesisParticle> particles, bool passOverFar = false,
                       StageClock* clock = nullptr);

  const ThesisGrid& grid() const { return grid_; }
  std::span<const double> field() const { return field_; }  // of the last update, x fastest

 private:
  void calcGradients();
  ThesisSurface calcPoints() const;
  std::size_t node(int x, int y, int z) const {
    return (std::size_t(z) * grid_.nodes.y() + y) * grid_.nodes.x() + x;
  }

  ThesisGrid grid_;
  double h_, iso_;
  std::vector<double> field_;
  std::vector<Vec3> gradients_;
};

}  // namespace resect::test
