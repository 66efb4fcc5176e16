// Where is the tip of a tool, as seen by the tissue where it is now: what lies under it, how near
// is tissue?
//
// Cost: of a still organ the bricks round the tip and under it, of one that moves a look at all its
// triangles, for its bricks are at rest.
#pragma once

#include "operation/live/present_surface.h"

namespace resect {

struct TipPlace {
  double below = 0;     // height (y, m) of the tissue or table top straight below the tip
  double distance = 0;  // m to the nearest vertex of the surface; 0 inside; at most kTipReach
};
constexpr double kTipReach = 0.03;

TipPlace placeOf(const PresentSurface& surface, const Vec3& tip);

}  // namespace resect
