// Parts tissue along the surface that a cutting edge sweeps. The edge is that of a blade or of
// closing jaws.
#pragma once

#include "collision/swept_blade.h"
#include "tools/working_part.h"

namespace resect {

// Queues an incision along `blade`, the sweep of the edge in the world. Also queues the severing of
// the bonds that cross the sweep. A bond is taken as the segment between the present positions of
// its two particles. The cost is proportional to the number of particles near the sweep.
void partAlong(const Touch& touch, SweptBlade blade, std::vector<TissueEdit>& edits);

// Appends the triangles of the sweep `more` to `blade`.
void append(SweptBlade& blade, const SweptBlade& more);

}  // namespace resect
