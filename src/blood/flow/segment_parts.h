// Finds the parts of an organ's tissue in which the organ's vessels end. A part is the body (the
// main part of the organ) or a piece that has been separated from it.
#pragma once

#include <span>
#include <vector>

#include "anatomy/vessel_state.h"
#include "organ/operated_organ.h"

namespace resect {

// For each cell, the part of the tissue to which the cell belongs. 0: the body. 1 or more: the
// number of a separated piece. SegmentPart::kCrumb: the cell belongs to debris (tiny pieces) or has
// no tissue. The cost is that of tissueParts() (organ/parts/tissue_parts.h).
std::vector<std::int32_t> partOfCells(const OperatedOrgan& organ);

// The vessel segments that do not belong to the body, by ascending number. A segment belongs to the
// part in which the leaves of its subtree (the last segments of its branches) end. If these leaves
// end in several parts, the segment belongs to one of these parts. part: the result of
// partOfCells().
std::vector<SegmentPart> segmentsApart(const Organ& organ, std::span<const std::int32_t> part);

}  // namespace resect
