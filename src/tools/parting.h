// How does an edge part tissue that it has passed through, be it a blade's or that of closing jaws?
#pragma once

#include "collision/swept_blade.h"
#include "tools/working_part.h"

namespace resect {

// Queues the incision along what the edge swept, world, and the bonds that it crosses where the
// particles are now. Cost: in proportion to the particles near the blade.
void partAlong(const Touch& touch, SweptBlade blade, std::vector<TissueEdit>& edits);

// One blade out of two.
void append(SweptBlade& blade, const SweptBlade& more);

}  // namespace resect
