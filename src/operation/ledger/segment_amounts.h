// Tells how much of each liver segment is left in the liver's body, that is, in its largest part
// (organ/parts/tissue_parts.h). The segments are the eight into which surgeons divide the liver,
// after Couinaud.
#pragma once

#include <vector>

#include "organ/operated_organ.h"

namespace resect {

struct SegmentAmount {
  int segment = 0;  // 1 to 8 (anatomy/liver_segments.h)
  // Volume of the segment: before the operation, and in the body now, m^3.
  double before = 0, body = 0;
};

// One entry per segment, ascending; empty if the segments cannot be found from the organ's vessels.
// Each particle counts as a full cell. Cost: the cost of tissueParts(), plus 0.2 us per particle.
std::vector<SegmentAmount> segmentAmounts(const OperatedOrgan& organ);

}  // namespace resect
