#include "tools/parts/inflow_clamp_part.h"

#include <algorithm>

#include "tools/tool.h"

namespace resect {
namespace {

constexpr double kShut = 0.95, kOpen = 0.5;  // squeeze
// m: round the portal vein before it branches. On a table the hilum lies under the liver: the clamp
// closes a tape that was laid round the hilum before, and whose ends come out beside the liver.
constexpr double kReach = 0.12;

// Distance of a place in the world from the trunk of the portal vein, m. The trunk moves with the
// particle nearest to its end.
double fromTrunk(const Touch& touch, const Vec3& place) {
  const Anatomy& anatomy = touch.organ.map->anatomy;
  const VesselRange portal = anatomy.range(VesselKind::PortalVein);
  if (portal.count == 0) return kReach + 1;
  const VesselSegment& trunk = anatomy.segments[std::size_t(portal.first)];
  Vec3 moved = Vec3::Zero();
  double least = -1;
  const Lattice& lattice = touch.organ.rest.lattice;
  Aabb near;
  near.grow(trunk.end);
  visitCellsIn(lattice, near.padded(2 * lattice.spacing.x()), [&](const Vec3i& at) {
    const std::int64_t cell = lattice.index(at);
    if (!touch.organ.alive[std::size_t(cell)]) return;
    const double d = (lattice.centre(at) - trunk.end).norm();
    if (least < 0 || d < least) least = d, moved = touch.tissue.displacement(cell);
  });
  const Vec3 from = trunk.start + moved, way = trunk.end - trunk.start;
  const double share = std::clamp((place - from).dot(way) / way.squaredNorm(), 0.0, 1.0);
  return (from + share * way - place).norm();
}

}  // namespace

void InflowClampPart::act(const Touch& touch, std::vector<TissueEdit>& edits) const {
  if (!touch.organ.map) return;
  const double before = touch.way.from.squeeze, now = touch.way.to.squeeze;
  const bool shuts = before < kShut && now >= kShut, opens = before > kOpen && now <= kOpen;
  if (shuts == touch.organ.vessels.inflowClamped && !opens) return;
  if (!shuts && !(opens && touch.organ.vessels.inflowClamped)) return;
  if (fromTrunk(touch, touch.way.to.pose * touch.model.tip) <= kReach)
    edits.push_back(touch.edit(ClampInflow{shuts}));
}

}  // namespace resect
