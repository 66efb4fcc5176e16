// What lies under a tool's tip, and how near tissue is to it, with the tissue where it is now.
//
// Cost: for still tissue the bricks round and under the tip; for moving tissue a pass over all
// triangles, since bricks are in rest space.
#pragma once

#include "operation/live/present_surface.h"

namespace resect {

struct TipPlace {
  // Height (y, m) of the tissue or table top straight below the tip; of a tip inside tissue its
  // own.
  double below = 0;
  double distance = 0;  // m to the nearest vertex of the surface; 0 inside; at most kTipReach
};
constexpr double kTipReach = 0.03;  // m

TipPlace placeOf(const PresentSurface& surface, const Vec3& tip);

}  // namespace resect
