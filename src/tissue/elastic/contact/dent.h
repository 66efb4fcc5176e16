// The depth of a patch of the tissue's surface inside an obstacle.
//
// Let P be the middle of the patch. If P is inside the obstacle, the line from P along the tissue's
// inward normal leaves the obstacle at a point Q. The vector from P to Q is called the way out. The
// depth is the component of the way out along the normal of the obstacle's surface at Q. The
// distance from P to the nearest face of the obstacle would be a wrong depth: for a patch near the
// edge of an instrument, the nearest face is the instrument's flank. The patch would be pushed
// sideways, and the instrument would slip into the tissue.
//
// P need not be on the surface: it may lie a margin below, if the obstacle is taken larger by the
// same margin. Nothing changes for an obstacle that is wide and flat. A narrow one becomes rounder:
// otherwise it could pass between patches that are as wide as itself.
#pragma once

#include "collision/signed_distance.h"

namespace resect {

struct Dent {
  double depth = 0;              // m; 0: no contact
  Vec3 outwards = Vec3::Zero();  // normal of the obstacle where the way out ends, unit
  double share = 0;              // share of the patch that the obstacle covers, 0 to 1
};

// Limits of the search for the way out of an obstacle.
struct WayOut {
  double deepest;  // greatest depth, m; larger depths are reduced to it
  // Greatest length of the way out, m. If the way out is longer, the patch is not in contact with
  // the obstacle.
  double farthest;
  // Least cosine of the angle between the way out and the obstacle's normal. If the way out is
  // longer than `deepest` and the cosine is below this limit, the patch is not in contact with the
  // obstacle. Example: a horizontal plate, the obstacle, is pressed into the top of a block of
  // tissue. Some patches on the upright sides of the block are then inside the plate. Their inward
  // normals are horizontal, so their ways out are horizontal, too. The plate's normal is vertical,
  // so the cosine is 0, and these patches are not in contact with the plate.
  double leastSlope;
  double margin = 0;  // m
};

// All vectors are in the obstacle's coordinates. place: middle of the patch, on the surface, m.
// inwards: the tissue's normal, unit, into the tissue. width: width of the patch, m. If there is
// contact and the way out is longer than `deepest`, the patch is pressed straight into the tissue:
// Dent::depth is `deepest`, and Dent::outwards is equal to `inwards`.
Dent dentIn(const SignedDistance& shape, const Vec3& place, const Vec3& inwards, double width,
            const WayOut& limits);

}  // namespace resect
