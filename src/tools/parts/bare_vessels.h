// Cutting vessels from which the tissue was taken away.
#pragma once

#include "collision/swept_blade.h"
#include "tools/working_part.h"

namespace resect {

// Appends the division of each bare vessel that the sweep of an edge, in the world, crosses where
// no tissue is left. Cost: the bare vessels.
void divideBareVessels(const Touch& touch, const SweptBlade& sweep, std::vector<TissueEdit>& edits);

}  // namespace resect
