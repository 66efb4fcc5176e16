// Finds the bleeding vessel end at an instrument's tip.
#pragma once

#include <functional>
#include <optional>

#include "tools/working_part.h"

namespace resect {

struct VesselAtTip {
  std::int32_t segment = -1;
  VesselEnd end = VesselEnd::Root;
  Vec3 rest = Vec3::Zero();  // position of the end in rest space, m
};

// Considers all vessel ends that bleed or draw in air, and finds the end that is nearest to
// `place`, a point in the world. Returns none if no such end is within `reach`, m. Among ends at
// almost the same distance, returns the end with the greatest flow. Distances are measured to the
// present positions of the ends. accepts(radius): whether a vessel of this radius, m, counts.
std::optional<VesselAtTip> bleedingEndNear(const Organ& organ, const TissueModel& tissue,
                                           const Vec3& place, double reach,
                                           const std::function<bool(double radius)>& accepts);

}  // namespace resect
