#include "anatomy/thinning/solid_shape.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "collision/signed_distance.h"
#include "geometry/measures.h"
#include "geometry/topology.h"

namespace resect {

SolidShape solidShape(const TriangleMesh& surface, double cell) {
  constexpr double kMostCells = 2e6;
  SolidShape shape;
  if (surface.triangles.empty()) return shape;
  const Aabb box = bounds(surface);
  const double cells = (box.size() / cell + Vec3::Ones()).prod();
  if (cells > kMostCells) cell *= math::cbrt(cells / kMostCells);
  Lattice& lattice = shape.lattice;
  lattice.spacing = Vec3::Constant(cell);
  lattice.dims = (box.size() / cell).array().ceil().cast<int>() + 1;
  lattice.origin = box.centre() - 0.5 * cell * (lattice.dims.cast<double>() - Vec3::Ones());
  shape.depth.assign(std::size_t(lattice.cellCount()), float(-SignedDistance::kFar));
  for (TriangleMesh& component : splitComponents(surface)) {
    if (volume(component) < 0)
      for (Triangle& t : component.triangles) std::swap(t[1], t[2]);
    const SignedDistance distance(component, 2 * cell, cell);
    visitCellsIn(lattice, distance.box(), [&](const Vec3i& at) {
      float& depth = shape.depth[std::size_t(lattice.index(at))];
      depth = std::max(depth, float(-distance(lattice.centre(at)).distance));
    });
  }
  return shape;
}

}  // namespace resect
