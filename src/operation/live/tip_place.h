// What lies under the tip of a tool, and how near tissue is to the tip. The tissue's present
// positions count.
//
// Cost: for still tissue, the bricks round and under the tip. For moving tissue, a pass over all
// triangles, since bricks are in rest space.
#pragma once

#include "operation/live/present_surface.h"

namespace resect {

struct TipPlace {
  // Height (y, m) of the tissue straight below the tip, or of the table top if there is no tissue.
  // If the tip is inside tissue: the height of the tip itself.
  double below = 0;
  // From the tip to the nearest vertex of the surface, m: 0 inside tissue, at most kTipReach.
  double distance = 0;
};
constexpr double kTipReach = 0.03;  // largest distance that is searched, m

TipPlace placeOf(const PresentSurface& surface, const Vec3& tip);

}  // namespace resect
