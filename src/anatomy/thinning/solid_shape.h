// The inside of a solid shape on a lattice.
#pragma once

#include <vector>

#include "geometry/triangle_mesh.h"
#include "sph/lattice.h"

namespace resect {

struct SolidShape {
  Lattice lattice;           // of cubic cells
  std::vector<float> depth;  // per cell: distance from the wall, m; 0 or less outside

  double cell() const { return lattice.spacing.x(); }  // m
};

// The shape contains all points inside any component of a closed surface, whichever way the
// component faces. So a vessel whose wall is drawn as two surfaces is filled, and vessels may
// overlap. The side of the cells is `cell`, m. If this would give more than two million cells, the
// side is larger.
SolidShape solidShape(const TriangleMesh& surface, double cell);

}  // namespace resect
