// Artery and bile duct beside each branch of the portal vein: the portal triads.
#pragma once

#include <vector>

#include "anatomy/growth/organ_inside.h"
#include "anatomy/growth/vessel_growth.h"

namespace resect {

// Appends the artery's segments and then the duct's. `segments`: the portal vein's, then those of
// other kinds, parents first. The artery runs on one side of the plane of each fork and the duct on
// the other, turning by less than 30 degrees a piece. Where they would meet a vessel they are
// pushed aside, narrowed or led round it; a branch for which there is no way ends.
void addTriads(std::vector<VesselSegment>& segments, const VesselGrowth& settings,
               const OrganInside& inside);

}  // namespace resect
