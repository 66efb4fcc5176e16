// Finds the bonds that a cut severs.
#pragma once

#include <vector>

#include "sph/lattice.h"
#include "tissue/tissue_model.h"

namespace resect {

// The bonds that a cut crosses in rest space, each once, in ascending order of cell, then
// direction. A bond is the line segment between the centres of its two cells. blade: the cut, in
// rest space, m. Cost: proportional to the number of cells near the cut times the number of its
// triangles.
std::vector<TissueBond> crossedBonds(const TissueModel& tissue, const Lattice& lattice,
                                     const SweptBlade& blade);

}  // namespace resect
