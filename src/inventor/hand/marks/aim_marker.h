// Shows on an organ's surface where a guided instrument works and towards what its edge faces: a
// ring at the point under the pointer, an arrow, and ticks on the ring's far side for the depth,
// one per 5 mm.
#pragma once

#include <vector>

#include "inventor/hand/marks/line_marks.h"
#include "operation/hand/surface_hand.h"

namespace resect {

std::vector<MarkLine> aimLines(const SurfaceHand& hand);

}  // namespace resect
