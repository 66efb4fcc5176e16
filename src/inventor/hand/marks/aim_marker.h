// Marks on an organ's surface where a guided instrument works: a ring at the working point, an
// arrow in the direction of its edge, and opposite the arrow one tick per 5 mm of depth.
#pragma once

#include <vector>

#include "inventor/hand/marks/line_marks.h"
#include "operation/hand/surface_hand.h"

namespace resect {

std::vector<MarkLine> aimLines(const SurfaceHand& hand);

}  // namespace resect
