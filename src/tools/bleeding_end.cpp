#include "tools/bleeding_end.h"

#include <cmath>

#include "tools/rest_place.h"

namespace resect {
namespace {

constexpr double kTogether = 0.002;  // m: ends no farther apart count as at one place
constexpr double kPulled = 0.03;     // m: how far from its place at rest an end is looked for

}  // namespace

std::optional<VesselAtTip> bleedingEndNear(const Organ& organ, const TissueModel& tissue,
                                           const Vec3& place, double reach,
                                           const std::function<bool(double radius)>& accepts) {
  if (!organ.map) return {};
  const std::optional<Vec3> rest = restPlace(organ, tissue, place);
  if (!rest) return {};
  std::optional<VesselAtTip> best;
  double least = 0, most = 0;
  for (const VesselInjury& injury : organ.vessels.injuries) {
    const VesselSegment& s = organ.map->anatomy.segments[std::size_t(injury.segment)];
    for (const VesselEnd end : {VesselEnd::Root, VesselEnd::Far}) {
      const double flow = injury.flow[int(end)];
      const Vec3 at = s.at(end == VesselEnd::Root ? injury.from : injury.to);
      if (flow == 0 || !accepts(s.radius) || injury.isSealed(end) ||
          organ.vessels.clipped(injury, end) || (at - *rest).norm() > reach + kPulled)
        continue;
      const double distance = (presentPlace(organ, tissue, at) - place).norm();
      if (distance > reach || (best && distance > least + kTogether)) continue;
      if (best && distance > least - kTogether && std::abs(flow) <= most) continue;
      best = VesselAtTip{injury.segment, end, at};
      least = distance, most = std::abs(flow);
    }
  }
  return best;
}

}  // namespace resect
