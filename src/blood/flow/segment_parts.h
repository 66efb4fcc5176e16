// In which parts of an organ's tissue its vessels end.
#pragma once

#include <span>
#include <vector>

#include "anatomy/vessel_state.h"
#include "organ/operated_organ.h"

namespace resect {

// Per cell: 0 in the body, from 1 on in a piece, SegmentPart::kCrumb in debris and where there is
// no tissue. Cost: that of tissueParts() (organ/parts/tissue_parts.h).
std::vector<std::int32_t> partOfCells(const OperatedOrgan& organ);

// The segments that do not lead into the body, ascending. A segment belongs to the part in which
// its leaves end; where they end in several parts, to one of these. part: from partOfCells().
std::vector<SegmentPart> segmentsApart(const Organ& organ, std::span<const std::int32_t> part);

}  // namespace resect
