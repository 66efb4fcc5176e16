#include "tools/clip_part.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "tools/rest_place.h"
#include "tools/tool.h"

namespace resect {
namespace {

constexpr double kCloses = 0.95;   // squeeze at which the clip is shut
constexpr double kReach = 0.008;   // m: how far from the jaws' middle a vessel is caught
constexpr double kBehind = 0.003;  // m: a clip sits this far behind the end of a cut vessel
constexpr double kThinnest = 0.3e-3, kWidest = 3.5e-3;  // m: radii that clips hold

// A place `way` metres from `share` of a segment towards the root, on the segment or on those
// before.
PlaceClip behind(const Anatomy& anatomy, std::int32_t segment, double share, double way) {
  for (;;) {
    const VesselSegment& s = anatomy.segments[std::size_t(segment)];
    const double length = s.length(), here = share * length;
    if (here >= way || s.parent < 0) return {segment, std::max(0.0, (here - way) / length)};
    way -= here;
    segment = s.parent;
    share = 1;
  }
}

}  // namespace

void ClipPart::act(const Touch& touch, std::vector<TissueEdit>& edits) const {
  const bool closes = touch.way.from.squeeze < kCloses && touch.way.to.squeeze >= kCloses;
  if (!closes || !touch.organ.map) return;
  const std::optional<Vec3> place =
      restPlace(touch.organ, touch.tissue, touch.way.to.pose * touch.model.tip);
  if (!place) return;
  const VesselMap& map = *touch.organ.map;
  std::vector<std::int32_t> near;
  Aabb box;
  box.grow(*place);
  map.index.near(box.padded(kReach), near);
  // The widest vessel that is cut, else the nearest that is whole.
  std::optional<PlaceClip> clip;
  double best = 0;
  for (const std::int32_t i : near) {
    const VesselSegment& s = map.anatomy.segments[std::size_t(i)];
    if (s.radius < kThinnest || s.radius > kWidest) continue;
    const Vec3 way = s.end - s.start;
    const double share = std::clamp((*place - s.start).dot(way) / way.squaredNorm(), 0.0, 1.0);
    const double distance = (s.at(share) - *place).norm();
    if (distance > kReach) continue;
    const VesselInjury* injury = touch.organ.vessels.injury(i);
    const bool open = injury && !touch.organ.vessels.clipped(*injury, VesselEnd::Root) &&
                      !injury->isSealed(VesselEnd::Root);
    const double worth = (open ? 1 + s.radius : 1e-3 / (1e-3 + distance));
    if (worth <= best) continue;
    best = worth;
    clip = open ? behind(map.anatomy, i, injury->from, kBehind) : PlaceClip{i, share};
  }
  if (clip) edits.push_back(touch.edit(*clip));
}

}  // namespace resect
