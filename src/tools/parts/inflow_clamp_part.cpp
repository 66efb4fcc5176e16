#include "tools/parts/inflow_clamp_part.h"

#include "tools/rest_place.h"
#include "tools/tool.h"

namespace resect {
namespace {

constexpr double kShut = 0.95, kOpen = 0.5;  // squeeze
// m: round the portal vein before it branches. On a table the hilum lies under the liver: the clamp
// closes a tape that was laid round the hilum before, and whose ends come out beside the liver.
constexpr double kClampReach = 0.12;

// Distance of a place in the world from the trunk of the portal vein, m.
double fromTrunk(const Touch& touch, const Vec3& place) {
  const Anatomy& anatomy = touch.organ.map->anatomy;
  const VesselRange portal = anatomy.range(VesselKind::PortalVein);
  if (portal.count == 0) return kClampReach + 1;
  const VesselSegment& trunk = anatomy.segments[std::size_t(portal.first)];
  // It moves with the tissue at its end.
  const Vec3 end = presentPlace(touch.organ, touch.tissue, trunk.end);
  const Vec3 start = trunk.start + end - trunk.end;
  return segmentDistance(start, end, place, place);
}

}  // namespace

void InflowClampPart::act(const Touch& touch, std::vector<TissueEdit>& edits) const {
  if (!touch.organ.map) return;
  const double before = touch.way.from.squeeze, now = touch.way.to.squeeze;
  const bool shuts = before < kShut && now >= kShut, opens = before > kOpen && now <= kOpen;
  const bool clamped = touch.organ.vessels.inflowClamped;
  if (!shuts && !(opens && clamped)) return;
  // A clamp that was left there and closes again is taken off.
  if (fromTrunk(touch, touch.way.to.pose * touch.model.tip) <= kClampReach)
    edits.push_back(touch.edit(ClampInflow{shuts && !clamped}));
}

}  // namespace resect
