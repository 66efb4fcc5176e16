#include "tools/parts/clip_part.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "tools/bleeding_end.h"
#include "tools/rest_place.h"
#include "tools/tool.h"

namespace resect {
namespace {

constexpr double kBehind = 0.003;   // m: a clip sits this far behind the end of a cut vessel
constexpr double kJaws = 0.004;     // m: half the length of the jaws
constexpr double kBetween = 0.002;  // m: clips on one vessel are farther apart

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
  const bool closes = touch.way.from.squeeze < kClipCloses && touch.way.to.squeeze >= kClipCloses;
  if (!closes || !touch.organ.map) return;
  const Vec3 tip = touch.way.to.pose * touch.model.tip;
  const std::optional<Vec3> place = restPlace(touch.organ, touch.tissue, tip);
  if (!place) return;
  const VesselMap& map = *touch.organ.map;
  if (const auto end = bleedingEndNear(touch.organ, touch.tissue, tip, kClipReach, holdsClip)) {
    const VesselInjury& injury = *touch.organ.vessels.injury(end->segment);
    const double length = map.anatomy.segments[std::size_t(end->segment)].length();
    edits.push_back(
        touch.edit(end->end == VesselEnd::Root
                       ? behind(map.anatomy, end->segment, injury.from, kBehind)
                       : PlaceClip{end->segment, std::min(1.0, injury.to + kBehind / length)}));
    return;
  }
  // No end that bleeds: a vessel that is whole.
  std::vector<std::int32_t> near;
  Aabb box;
  box.grow(*place);
  map.index.near(box.padded(kClipReach), near);
  std::optional<PlaceClip> clip;
  double best = 0;
  for (const std::int32_t i : near) {
    const VesselSegment& s = map.anatomy.segments[std::size_t(i)];
    if (!holdsClip(s.radius) || touch.organ.vessels.injury(i)) continue;
    const Vec3 way = s.end - s.start;
    const double share = std::clamp((*place - s.start).dot(way) / way.squaredNorm(), 0.0, 1.0);
    const double distance = (s.at(share) - *place).norm();
    const bool there = std::ranges::any_of(touch.organ.vessels.clips, [&](const VesselClip& c) {
      return c.segment == i && !c.byHeat && std::abs(c.share - share) * s.length() < kBetween;
    });
    // Between the jaws the widest counts, beside them the nearest.
    const double worth = distance < kJaws ? kClipReach + s.radius : kClipReach - distance;
    if (worth > best && !there) best = worth, clip = PlaceClip{i, share};
  }
  if (clip) edits.push_back(touch.edit(*clip));
}

}  // namespace resect
