// Discretisation: the cells of a lattice that a closed mesh fills, and the share of each.
#pragma once

#include "base/progress.h"
#include "geometry/triangle_mesh.h"
#include "sph/discretization.h"
#include "sph/lattice.h"

namespace resect {

// Most cells of a lattice; for more an Error is thrown.
inline constexpr std::int64_t kMaxCells = 200'000'000;

// Cubic cells of side `spacing` > 0, m, that tile the box from its lowest corner on: cell centres
// lie at min + (i + 1/2) spacing, as many as cover the box. (At 5 mm the Visible Human liver gets
// 13 114 particles.) A flat box gets one cell across; an empty one is an Error.
Lattice latticeForSpacing(const Aabb& box, double spacing);

// The thesis's grid as its text describes it: dims >= 1 samples along each axis of the box, the
// first at min, spacing (max - min) / dims per axis; one more cell at each far end, for the part
// beyond the last sample. Such a lattice is not cubic unless the box is: its organ can be shown and
// carved but cannot deform.
Lattice latticeForDims(const Aabb& box, const Vec3i& dims);

// The thesis's grid as its files show it (docs/decisions/0002-thesis-grid-is-cubic.md): cubic, the
// box's longest side / dims, the first sample at min; as many cells as cover the box.
Lattice cubicLatticeForDims(const Aabb& box, int dims);

// `mesh` is closed and oriented outwards; the part outside the lattice's box is ignored. inside:
// the cell's centre is inside, exactly (collision/columns.h). value: 100 x the share of 4 x 4 x 4
// samples of the cell that are inside, at least 100/64 where the centre is inside. `progress` is
// called from the calling thread. Same bits at any number of threads. Cost: 17 columns per column
// of cells (collision/columns.h) and a pass over the cells.
Discretization discretize(const TriangleMesh& mesh, const Lattice& lattice,
                          const Progress& progress = {});

}  // namespace resect
