// Surgeons divide the liver into eight segments, after Couinaud. How much of each segment is left
// in the liver's body, that is, its largest part (organ/parts/tissue_parts.h).
#pragma once

#include <vector>

#include "organ/operated_organ.h"

namespace resect {

struct SegmentAmount {
  int segment = 0;              // 1 to 8 (anatomy/liver_segments.h)
  double before = 0, body = 0;  // its volume before the operation, and now in the body, m^3
};

// One entry per segment, ascending; empty if the segments cannot be found from the organ's vessels.
// Each particle counts as a full cell. Cost: the cost of tissueParts(), plus 0.2 us per particle.
std::vector<SegmentAmount> segmentAmounts(const OperatedOrgan& organ);

}  // namespace resect
