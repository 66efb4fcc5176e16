// Which bleeding vessel an instrument has at its tip.
#pragma once

#include <functional>
#include <optional>

#include "tools/working_part.h"

namespace resect {

struct VesselAtTip {
  std::int32_t segment = -1;
  VesselEnd end = VesselEnd::Root;
  Vec3 rest = Vec3::Zero();  // of the end, m
};

// The end of a vessel that bleeds within `reach`, m, of a place in the world: the nearest, and of
// those that lie together the one that bleeds most. It looks where the ends are now, so it finds
// the end that a viewer marks, however the tissue is pulled. accepts: for a radius, m.
std::optional<VesselAtTip> bleedingEndNear(const Organ& organ, const TissueModel& tissue,
                                           const Vec3& place, double reach,
                                           const std::function<bool(double radius)>& accepts);

}  // namespace resect
