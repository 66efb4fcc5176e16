// The height of the tissue under the tip of a tool, and the distance of the tip from tissue, both
// for the tissue's present position.
//
// Cost for still tissue: proportional to the number of bricks (blocks of 4 x 4 x 4 nodes of the
// colour field's grid) round and under the tip. Cost for moving tissue: a pass over all triangles,
// since bricks are in rest space.
#pragma once

#include "operation/live/present_surface.h"

namespace resect {

struct TipPlace {
  // Height, m (the coordinate y), of the surface straight below the tip. If there is no surface
  // below, the height of the table's top. If the tip is inside tissue, the height of the tip
  // itself.
  double below = 0;
  // Distance of the tip from the nearest vertex of the surface, m. It is 0 if the tip is inside
  // tissue, and never more than kTipReach.
  double distance = 0;
};
constexpr double kTipReach = 0.03;  // largest distance that is searched, m

// tip: world, m.
TipPlace placeOf(const PresentSurface& surface, const Vec3& tip);

}  // namespace resect
