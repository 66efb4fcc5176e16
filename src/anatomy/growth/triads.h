// Grows an artery and a bile duct beside each branch of the portal vein. The three vessels together
// are called a portal triad.
#pragma once

#include <vector>

#include "anatomy/growth/organ_inside.h"
#include "anatomy/growth/vessel_growth.h"

namespace resect {

// Appends the segments of the artery, then the segments of the bile duct. If `segments` already
// contains an artery, no artery is grown; the same holds for the bile duct. segments: the segments
// of the portal vein, then the segments of other kinds; each segment after its parent. At each fork
// of the vein, the artery runs on one side of the fork's plane and the duct on the other side.
// Artery and duct consist of straight pieces. Where they wind round the vein, each piece winds by
// less than 30 degrees. A branch that would meet another vessel is pushed aside, narrowed, or led
// round that vessel. If all this fails, the branch ends before the other vessel.
void addTriads(std::vector<VesselSegment>& segments, const VesselGrowth& settings,
               const OrganInside& inside);

}  // namespace resect
