// How deep a patch of the surface of tissue is inside an obstacle.
//
// The depth is measured along the tissue's normal, inwards, to where the obstacle ends. The
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

// How the way out of an obstacle is looked for.
struct WayOut {
  double deepest;   // m; no depth is larger
  double farthest;  // m; if the obstacle ends farther away, the patch is edge-on and not touched
  // The same where a way longer than `deepest` leaves the obstacle more obliquely than this: cosine
  // of the angle between the way and the obstacle's normal. The side of a block is edge-on to a
  // plate on the block.
  double leastSlope;
};

// All in the obstacle's coordinates. place: middle of the patch. inwards: unit, into the tissue.
// width: of the patch, m.
Dent dentIn(const SignedDistance& shape, const Vec3& place, const Vec3& inwards, double width,
            const WayOut& limits);

}  // namespace resect
