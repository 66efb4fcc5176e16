// The inside of a solid shape on a lattice.
#pragma once

#include <vector>

#include "geometry/triangle_mesh.h"
#include "sph/lattice.h"

namespace resect {

struct SolidShape {
  Lattice lattice;           // of cubic cells
  std::vector<float> depth;  // per cell: distance to the nearest wall, m; 0 or less outside

  double cell() const { return lattice.spacing.x(); }  // m
};

// All that lies inside any component of a closed surface, whichever way it faces: walls of vessels
// that are drawn as two surfaces, and vessels that are drawn through each other, are filled. Cells
// have a side of `cell` m, or more where there would be over two million of them.
SolidShape solidShape(const TriangleMesh& surface, double cell);

}  // namespace resect
