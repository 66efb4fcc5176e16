#include "tools/parts/clip_part.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "tools/bleeding_end.h"
#include "tools/rest_place.h"
#include "tools/tool.h"

namespace resect {
namespace {

constexpr double kBehind = 0.003;   // m: a clip sits this far behind the end of a cut vessel
constexpr double kJaws = 0.004;     // m: half the length of the jaws
constexpr double kBetween = 0.002;  // m: clips on one vessel are farther apart
constexpr double kAstray = 0.01;    // m: how far a vessel may be from where its surroundings put it
constexpr double kSample = 0.0005;  // m: distance of the places that are looked at along a vessel

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

struct Nearest {
  double share, distance;  // of the segment's length; m
};

// The place of a segment that is now nearest to a point of the world. Only places within `around`,
// m, of that point's place at rest are looked at.
Nearest nearestNow(const Touch& touch, const VesselSegment& s, const Vec3& point, const Vec3& rest,
                   double around) {
  const int steps = std::max(1, int(std::ceil(s.length() / kSample)));
  Nearest nearest{0, std::numeric_limits<double>::infinity()};
  for (int k = 0; k <= steps; ++k) {
    const double share = double(k) / steps;
    if ((s.at(share) - rest).norm() > around) continue;
    const double distance = (presentPlace(touch.organ, touch.tissue, s.at(share)) - point).norm();
    if (distance < nearest.distance) nearest = {share, distance};
  }
  return nearest;
}

// On a vessel that bleeds at least `least`, m^3/s, within `reach` of the tip, behind its nearest
// end.
std::optional<PlaceClip> onBleeding(const Touch& touch, const Vec3& tip, double reach,
                                    double least) {
  const auto end = bleedingEndNear(touch.organ, touch.tissue, tip, reach, holdsClip);
  if (!end) return {};
  const Anatomy& anatomy = touch.organ.map->anatomy;
  const VesselInjury& injury = *touch.organ.vessels.injury(end->segment);
  if (std::abs(injury.flow[int(end->end)]) < least) return {};
  if (end->end == VesselEnd::Root) return behind(anatomy, end->segment, injury.from, kBehind);
  const double length = anatomy.segments[std::size_t(end->segment)].length();
  return PlaceClip{end->segment, std::min(1.0, injury.to + kBehind / length)};
}

// On a vessel that is whole within `reach` of the tip. bare: only on bare vessels.
std::optional<PlaceClip> onWhole(const Touch& touch, const Vec3& tip, const Vec3& rest,
                                 double reach, bool bare) {
  const VesselMap& map = *touch.organ.map;
  const VesselState& state = touch.organ.vessels;
  std::vector<std::int32_t> near;
  Aabb box;
  box.grow(rest);
  map.index.near(box.padded(reach + kAstray), near);
  std::optional<PlaceClip> clip;
  double best = 0;
  for (const std::int32_t i : near) {
    const VesselSegment& s = map.anatomy.segments[std::size_t(i)];
    if (!holdsClip(s.radius) || (bare && !std::ranges::binary_search(state.bared, i))) continue;
    const auto [share, distance] = nearestNow(touch, s, tip, rest, reach + kAstray);
    const VesselInjury* injury = state.injury(i);
    if (distance > reach || (injury && share >= injury->from && share <= injury->to)) continue;
    const bool there = std::ranges::any_of(state.clips, [&](const VesselClip& c) {
      return c.segment == i && !c.byHeat && std::abs(c.share - share) * s.length() < kBetween;
    });
    // Between the jaws a wide vessel counts more than a near one, but of two segments of one vessel
    // the near one; beside the jaws the nearest.
    const double worth =
        distance < kJaws ? kClipReach + s.radius - 0.25 * distance : kClipReach - distance;
    if (worth > best && !there) best = worth, clip = PlaceClip{i, share};
  }
  return clip;
}

}  // namespace

void ClipPart::act(const Touch& touch, std::vector<TissueEdit>& edits) const {
  const bool closes = touch.way.from.squeeze < kClipCloses && touch.way.to.squeeze >= kClipCloses;
  if (!closes || !touch.organ.map) return;
  const Vec3 tip = touch.way.to.pose * touch.model.tip;
  const std::optional<Vec3> rest = restPlace(touch.organ, touch.tissue, tip);
  if (!rest) return;
  std::optional<PlaceClip> clip = onBleeding(touch, tip, kJaws, kTrickle);
  if (!clip) clip = onWhole(touch, tip, *rest, kJaws, true);
  if (!clip) clip = onBleeding(touch, tip, kClipReach, 0);
  if (!clip) clip = onWhole(touch, tip, *rest, kClipReach, false);
  if (clip) edits.push_back(touch.edit(*clip));
}

}  // namespace resect
