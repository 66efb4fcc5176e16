// Cuts bare vessels: those from which the tissue was taken away.
#pragma once

#include "collision/swept_blade.h"
#include "tools/working_part.h"

namespace resect {

// Appends a DivideVessel edit for each bare vessel that a sweeping edge crosses at a point where no
// tissue is left. sweep: of the edge in this frame, world, m. Cost: proportional to the number of
// bare vessels.
void divideBareVessels(const Touch& touch, const SweptBlade& sweep, std::vector<TissueEdit>& edits);

}  // namespace resect
