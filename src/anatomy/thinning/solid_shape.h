// The inside of a solid shape on a lattice.
#pragma once

#include <vector>

#include "geometry/triangle_mesh.h"
#include "sph/lattice.h"

namespace resect {

struct SolidShape {
  Lattice lattice;           // of cubic cells
  std::vector<float> depth;  // per cell: distance from the wall, m; 0 or less outside

  double cell() const { return lattice.spacing.x(); }  // side of a cell, m
};

// A point belongs to the shape if it is inside any component of the closed surface. It does not
// matter whether the component is oriented outwards or inwards. So a vessel whose wall is drawn as
// two surfaces is filled, and vessels may overlap. The side of the cells is `cell`, m. If there
// would be more than two million cells, the side is larger than `cell`.
SolidShape solidShape(const TriangleMesh& surface, double cell);

}  // namespace resect
