// Discretisation: finds which cells of a lattice a closed mesh fills, and how full each of them is.
#pragma once

#include "base/progress.h"
#include "geometry/triangle_mesh.h"
#include "sph/discretization.h"
#include "sph/lattice.h"

namespace resect {

// Largest number of cells of a lattice. A larger lattice is an Error.
inline constexpr std::int64_t kMaxCells = 200'000'000;

// The lattice of cubic cells of side `spacing` > 0, m, that covers the box. The first cell begins
// at the box's lowest corner (min). So cell centres lie at min + (i + 1/2) spacing along each axis.
// (At 5 mm the Visible Human liver gets 13 114 particles, that is, cells whose centre lies inside.)
// If the box has no extent along an axis, there is one cell along this axis. An empty box is an
// Error.
Lattice latticeForSpacing(const Aabb& box, double spacing);

// The grid that the text of the thesis describes (the diploma thesis that Resect continues). Along
// each axis of the box there are dims (>= 1) samples. The first lies at the box's lowest corner,
// and the spacing is the box's side / dims. The lattice has one more cell at the upper end of each
// axis, for the part of the box beyond the last sample. An organ with this lattice can be shown and
// carved. It can deform only if the three spacings are equal.
Lattice latticeForDims(const Aabb& box, const Vec3i& dims);

// The grid that the files of the thesis have (docs/decisions/0002-thesis-grid-is-cubic.md). The
// cells are cubes whose side is the box's longest side / dims. The first sample lies at the box's
// lowest corner. There are just enough cells to cover the box.
Lattice cubicLatticeForDims(const Aabb& box, int dims);

// `mesh` must be closed and oriented outwards; the part outside the lattice's box is ignored. In
// the result, `inside` tells for each cell whether its centre is inside the mesh; this is decided
// exactly (collision/columns.h). `value` is computed from 4 x 4 x 4 samples per cell: it is 100
// times the share of samples that are inside the mesh, but at least 100/64 if the centre is inside.
// `progress` is called only in the thread that calls discretize(). The result has the same bits at
// any number of threads. Cost: 17 lines through the mesh (collision/columns.h) for each column of
// cells, and a pass over the cells.
Discretization discretize(const TriangleMesh& mesh, const Lattice& lattice,
                          const Progress& progress = {});

}  // namespace resect
