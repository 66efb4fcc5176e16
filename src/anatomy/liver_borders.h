// Finds the borders between parts of a liver. A border runs near hepatic veins and away from
// branches of the portal vein. The volumes of the parts are close to their usual values.
#pragma once

#include <vector>

#include "anatomy/anatomy.h"
#include "anatomy/liver_frame.h"

namespace resect {

// The first of two neighbouring parts has a share of the volume of both parts together. usual: the
// usual share. off: the largest allowed difference from the usual share.
struct PartShare {
  double usual = 0.5, off = 0.5;
};

// The border between two parts side by side. The first part is the right one. The border is a
// half-plane that begins at the axis of the frame. The result is the angle of the half-plane
// (LiverFrame::angle()). angles: angles of the portal vein's terminals (the ends of its tree) in
// both parts.
double bestPlane(const Anatomy& anatomy, const LiverFrame& frame, std::vector<double> angles,
                 const PartShare& share);

// The border between two parts one above the other. The first part is the lower one. The border is
// a plane at right angles to the axis, at the height of the portal vein's fork. If this gives the
// first part a share that is not allowed, the plane is moved up or down, but no farther than
// necessary. The result is the height of the plane (LiverFrame::height()). heights: heights of the
// portal vein's terminals in both parts.
double bestLevel(std::vector<double> heights, const PartShare& share);

}  // namespace resect
