// Artery and bile duct beside each branch of the portal vein: the portal triads.
#pragma once

#include <vector>

#include "anatomy/growth/organ_inside.h"
#include "anatomy/growth/vessel_growth.h"

namespace resect {

// Appends the segments of the artery and then those of the bile duct; a kind that is already there
// is not grown. segments: those of the portal vein, then those of other kinds, parents first. The
// artery runs on one side of the plane of each fork, the duct on the other side. Each straight
// piece turns about the vein by less than 30 degrees. A branch that would meet another vessel is
// pushed aside, narrowed, or led round it; if no way is found, the branch ends there.
void addTriads(std::vector<VesselSegment>& segments, const VesselGrowth& settings,
               const OrganInside& inside);

}  // namespace resect
