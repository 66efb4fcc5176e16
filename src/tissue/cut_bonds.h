// Which bonds a cut severs.
#pragma once

#include <vector>

#include "sph/lattice.h"
#include "tissue/tissue_model.h"

namespace resect {

// The bonds that a cut crosses at rest, each once, by ascending cell and direction. A bond is the
// segment between the centres of its two cells. Cost: that of the cells near the cut, times its
// triangles. blade: in rest space, m.
std::vector<TissueBond> crossedBonds(const TissueModel& tissue, const Lattice& lattice,
                                     const SweptBlade& blade);

}  // namespace resect
