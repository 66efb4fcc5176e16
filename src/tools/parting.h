// Parts tissue along the sweep of an edge, of a blade or of closing jaws.
#pragma once

#include "collision/swept_blade.h"
#include "tools/working_part.h"

namespace resect {

// Queues an incision along the edge's sweep `blade` (world), and the severing of the bonds that
// cross the sweep. A bond is the segment between the present positions of its two particles. The
// cost is proportional to the number of particles near the sweep.
void partAlong(const Touch& touch, SweptBlade blade, std::vector<TissueEdit>& edits);

// Appends the triangles of another sweep to `blade`.
void append(SweptBlade& blade, const SweptBlade& more);

}  // namespace resect
