// Marks where a guided instrument works. An instrument is guided if it follows the surface at which
// the pointer points. The marks are a ring round the working point (workPoint() in
// operation/hand/surface_hand.h), an arrow, and ticks. The arrow has the direction of
// SurfaceHand::heading. The ticks are opposite the arrow; each tick stands for 5 mm of the working
// point's depth below the surface. There are no ticks while the hand has a target
// (SurfaceHand::target).
#pragma once

#include <vector>

#include "inventor/hand/marks/line_marks.h"
#include "operation/hand/surface_hand.h"

namespace resect {

std::vector<MarkLine> aimLines(const SurfaceHand& hand);

}  // namespace resect
