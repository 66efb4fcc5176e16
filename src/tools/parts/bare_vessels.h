// Cuts bare vessels: vessels round which the tissue has been removed.
#pragma once

#include "collision/swept_blade.h"
#include "tools/working_part.h"

namespace resect {

// Appends a DivideVessel edit for each bare vessel that a cutting edge crosses at a point where no
// tissue is left. sweep: the surface over which the edge moves in this frame, world, m. Cost:
// proportional to the number of bare vessels.
void divideBareVessels(const Touch& touch, const SweptBlade& sweep, std::vector<TissueEdit>& edits);

}  // namespace resect
