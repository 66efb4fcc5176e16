// How deep a patch of the surface of tissue is inside an obstacle.
//
// The depth is measured along the tissue's own normal, inwards, to where the obstacle ends. The
// nearest face of the obstacle would not do: beside the edge of an instrument it is the flank, and
// the instrument would slip into the tissue.
#pragma once

#include "collision/signed_distance.h"

namespace resect {

struct Dent {
  double depth = 0;              // m, part of the way along the obstacle's normal; 0: no contact
  Vec3 outwards = Vec3::Zero();  // normal of the obstacle's surface
  double share = 0;              // of the patch that the obstacle covers, 0 to 1
};

// All in the obstacle's coordinates. place: middle of the patch. inwards: unit, into the tissue.
// width: of the patch, m. deepest: depth beyond which the way out is not looked for, m.
Dent dentIn(const SignedDistance& shape, const Vec3& place, const Vec3& inwards, double width,
            double deepest);

}  // namespace resect
