// Discretisation: which cells of a lattice a closed mesh fills, and how full each of them is.
#pragma once

#include "base/progress.h"
#include "geometry/triangle_mesh.h"
#include "sph/discretization.h"
#include "sph/lattice.h"

namespace resect {

// Largest number of cells of a lattice; an Error is thrown for more.
inline constexpr std::int64_t kMaxCells = 200'000'000;

// Cubic cells of side `spacing` > 0, m, that tile the box from its lowest corner (min) on, as many
// as cover it: cell centres lie at min + (i + 1/2) spacing along each axis. (At 5 mm the Visible
// Human liver gets 13 114 particles.) A flat box gets one cell across; an empty box is an Error.
Lattice latticeForSpacing(const Aabb& box, double spacing);

// The thesis's grid as its text describes it: dims >= 1 samples along each axis of the box, the
// first at the box's lowest corner, with a spacing of side / dims for each axis. One more cell at
// the upper end of each axis covers the part beyond the last sample. Unless the three spacings are
// equal, the organ of such a lattice can be shown and carved but cannot deform.
Lattice latticeForDims(const Aabb& box, const Vec3i& dims);

// The thesis's grid as its files show it (docs/decisions/0002-thesis-grid-is-cubic.md): cubic cells
// whose side is the box's longest side / dims, the first sample at the box's lowest corner, as many
// cells as cover the box.
Lattice cubicLatticeForDims(const Aabb& box, int dims);

// `mesh` must be closed and oriented outwards; the part outside the lattice's box is ignored. In
// the result `inside` says whether the cell's centre is inside the mesh, decided exactly
// (collision/columns.h); `value` is 100 times the share of the cell's 4 x 4 x 4 samples that are
// inside, but at least 100/64 where the centre is inside. `progress` is called from the calling
// thread. Same bits at any number of threads. Cost: 17 columns (collision/columns.h) per column of
// cells, and a pass over the cells.
Discretization discretize(const TriangleMesh& mesh, const Lattice& lattice,
                          const Progress& progress = {});

}  // namespace resect
