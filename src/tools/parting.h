// Parts tissue along the sweep of an edge: a blade's or that of closing jaws.
#pragma once

#include "collision/swept_blade.h"
#include "tools/working_part.h"

namespace resect {

// Queues an incision along the edge's sweep (world) and the severing of the bonds that cross it at
// the particles' present positions. Cost: proportional to the particles near the blade.
void partAlong(const Touch& touch, SweptBlade blade, std::vector<TissueEdit>& edits);

// Appends the triangles of another sweep.
void append(SweptBlade& blade, const SweptBlade& more);

}  // namespace resect
