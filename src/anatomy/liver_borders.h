// Where the borders between parts of a liver run: near hepatic veins, away from branches of the
// portal vein, and so that each part has a usual share of the liver.
#pragma once

#include <vector>

#include "anatomy/anatomy.h"
#include "anatomy/liver_frame.h"

namespace resect {

// The share that the first of two parts has of both together: usually, and how much more or less it
// may have.
struct PartShare {
  double usual = 0.5, off = 0.5;
};

// Of two parts side by side, the right one is the first. The border is a half-plane from the axis.
// The result is its angle (LiverFrame::angle()). angles: those of the portal terminals in both
// parts.
double bestPlane(const Anatomy& anatomy, const LiverFrame& frame, std::vector<double> angles,
                 const PartShare& share);

// Of two parts one above the other, the lower one is the first. The border is the level of the
// portal vein's fork, moved up or down as little as the bounds of the share demand. The result is
// its height (LiverFrame::height()). heights: those of the portal terminals in both parts.
double bestLevel(std::vector<double> heights, const PartShare& share);

}  // namespace resect
