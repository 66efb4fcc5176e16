// Marks on an organ's surface where a guided instrument works: a ring at the working point, an
// arrow in the direction of the hand's heading (SurfaceHand::heading), and opposite the arrow one
// tick per 5 mm of working depth. There are no ticks while the hand works at a target.
#pragma once

#include <vector>

#include "inventor/hand/marks/line_marks.h"
#include "operation/hand/surface_hand.h"

namespace resect {

std::vector<MarkLine> aimLines(const SurfaceHand& hand);

}  // namespace resect
