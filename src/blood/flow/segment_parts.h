// The parts of an organ's tissue in which its vessels end.
#pragma once

#include <span>
#include <vector>

#include "anatomy/vessel_state.h"
#include "organ/operated_organ.h"

namespace resect {

// The part of the tissue that each cell belongs to: 0 for the body, from 1 on the number of a
// separated piece, SegmentPart::kCrumb for debris and where there is no tissue. Cost: that of
// tissueParts() (organ/parts/tissue_parts.h).
std::vector<std::int32_t> partOfCells(const OperatedOrgan& organ);

// The segments that belong to another part than the body, ascending. A segment belongs to the part
// in which its leaves end; if they end in several parts, to one of these. part: the result of
// partOfCells().
std::vector<SegmentPart> segmentsApart(const Organ& organ, std::span<const std::int32_t> part);

}  // namespace resect
