// Finds the bonds that a cut severs. A bond connects two neighbouring cells of tissue. In rest
// space, the bond is the line segment between the centres of the two cells.
#pragma once

#include <vector>

#include "sph/lattice.h"
#include "tissue/tissue_model.h"

namespace resect {

// The bonds that a cut crosses in rest space. Each bond is listed once; bonds are sorted by cell,
// then by direction. blade: the surface of the cut, in rest space, m. Cost: proportional to the
// number of cells near the cut, times the number of triangles of `blade`.
std::vector<TissueBond> crossedBonds(const TissueModel& tissue, const Lattice& lattice,
                                     const SweptBlade& blade);

}  // namespace resect
