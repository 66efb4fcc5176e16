#include "anatomy/vessel_state.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "base/elementary.h"

namespace resect {
namespace {

VesselInjury& injuryOf(VesselState& state, std::int32_t segment) {
  auto at = std::ranges::lower_bound(state.injuries, segment, {}, &VesselInjury::segment);
  if (at == state.injuries.end() || at->segment != segment) {
    at = state.injuries.insert(at, VesselInjury{});
    at->segment = segment;
  }
  return *at;
}

// Cuts a filament between two shares of its length. A new cut opens ends that were sealed.
void cutFilament(VesselState& state, std::int32_t segment, int filament, double from, double to,
                 std::vector<std::int32_t>& cut) {
  VesselInjury& injury = injuryOf(state, segment);
  const bool wider = from < injury.from || to > injury.to;
  const bool first = !(injury.cut >> filament & 1);
  if (!first && !wider) return;
  injury.cut |= 1u << filament;
  if (from < injury.from) injury.from = from, injury.sealed &= std::uint8_t(~1u);
  if (to > injury.to) injury.to = to, injury.sealed &= std::uint8_t(~2u);
  if (first && (cut.empty() || cut.back() != segment)) cut.push_back(segment);
}

// The part of the way from a to b that lies in the box, as shares.
std::optional<std::pair<double, double>> partIn(const Aabb& box, const Vec3& a, const Vec3& b) {
  double from = 0, to = 1;
  for (int i = 0; i < 3; ++i) {
    const double way = b[i] - a[i];
    if (std::abs(way) < 1e-12) {
      if (a[i] < box.min[i] || a[i] > box.max[i]) return {};
      continue;
    }
    const double u = (box.min[i] - a[i]) / way, v = (box.max[i] - a[i]) / way;
    from = std::max(from, std::min(u, v));
    to = std::min(to, std::max(u, v));
  }
  if (from >= to) return {};
  return std::pair{from, to};
}

void bare(VesselState& state, std::int32_t segment) {
  const auto at = std::ranges::lower_bound(state.bared, segment);
  if (at == state.bared.end() || *at != segment) state.bared.insert(at, segment);
}

}  // namespace

const VesselInjury* VesselState::injury(std::int32_t segment) const {
  const auto at = std::ranges::lower_bound(injuries, segment, {}, &VesselInjury::segment);
  return at != injuries.end() && at->segment == segment ? &*at : nullptr;
}

bool VesselState::clipped(const VesselInjury& injury, VesselEnd end) const {
  return std::ranges::any_of(clips, [&](const VesselClip& clip) {
    return clip.segment == injury.segment &&
           (end == VesselEnd::Root ? clip.share <= injury.from : clip.share >= injury.to);
  });
}

bool VesselState::clipped(std::int32_t segment) const {
  return std::ranges::any_of(clips,
                             [&](const VesselClip& clip) { return clip.segment == segment; });
}

void VesselState::addClip(const VesselClip& clip) {
  const auto before = [](const VesselClip& a, const VesselClip& b) {
    return a.segment < b.segment || (a.segment == b.segment && a.share < b.share);
  };
  clips.insert(std::ranges::upper_bound(clips, clip, before), clip);
}

Filament filamentOf(const VesselSegment& segment, int filament) {
  if (filament == 0) return {segment.start, segment.end};
  const Vec3 along = (segment.end - segment.start).normalized();
  const Vec3 u = along.cross(std::abs(along.x()) < 0.7 ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitY()))
                     .normalized();
  const Vec3 v = along.cross(u);
  const bool inner = filament <= 6;
  const double angle =
      inner ? (filament - 1) * std::numbers::pi / 3 : (filament - 7 + 0.5) * std::numbers::pi / 6;
  const double r = (inner ? 0.5 : 0.87) * segment.radius;
  const Vec3 offset = r * (math::cos(angle) * u + math::sin(angle) * v);
  return {segment.start + offset, segment.end + offset};
}

void cutVessels(const Anatomy& anatomy, const VesselIndex& index, const SweptBlade& blade,
                VesselState& state, std::vector<std::int32_t>& cut) {
  tearVessels(anatomy, index, blade, std::numeric_limits<double>::infinity(), state, cut);
}

void tearVessels(const Anatomy& anatomy, const VesselIndex& index, const SweptBlade& face,
                 double spared, VesselState& state, std::vector<std::int32_t>& cut) {
  if (anatomy.empty() || face.empty()) return;
  std::vector<std::int32_t> near;
  index.near(face.bounds, near);
  for (const std::int32_t i : near) {
    const VesselSegment& s = anatomy.segments[std::size_t(i)];
    if (s.radius >= spared) {
      if (crossing(face, s.start, s.end)) bare(state, i);
      continue;
    }
    for (int f = 0; f < kFilaments; ++f) {
      const Filament filament = filamentOf(s, f);
      if (const auto at = crossing(face, filament.start, filament.end))
        cutFilament(state, i, f, at->share, at->share, cut);
    }
  }
}

void cutVessels(const Anatomy& anatomy, const VesselIndex& index, const Aabb& box, double spared,
                VesselState& state, std::vector<std::int32_t>& cut) {
  if (anatomy.empty()) return;
  std::vector<std::int32_t> near;
  index.near(box, near);
  for (const std::int32_t i : near) {
    const VesselSegment& s = anatomy.segments[std::size_t(i)];
    if (s.radius >= spared) {
      if (partIn(box, s.start, s.end)) bare(state, i);
      continue;
    }
    for (int f = 0; f < kFilaments; ++f) {
      const Filament filament = filamentOf(s, f);
      if (const auto part = partIn(box, filament.start, filament.end))
        cutFilament(state, i, f, part->first, part->second, cut);
    }
  }
}

void divideVessel(std::int32_t segment, double share, VesselState& state,
                  std::vector<std::int32_t>& cut) {
  for (int f = 0; f < kFilaments; ++f) cutFilament(state, segment, f, share, share, cut);
}

void sealVessels(const Anatomy& anatomy, const VesselIndex& index, const Aabb& box,
                 const std::function<double(const Vec3&)>& coagulated, VesselState& state) {
  constexpr double kSealed = 0.9;        // share that must be coagulated
  constexpr double kBetween = 1.5e-3;    // m: of places along a vessel
  constexpr double kPerimeter = 0.5e-3;  // m: thinner vessels are tested in their middle only
  const auto welded = [&](const VesselSegment& s, double share) {
    const Vec3 middle = s.at(share);
    if (coagulated(middle) < kSealed) return false;
    if (s.radius < kPerimeter) return true;
    const Vec3 along = (s.end - s.start).normalized();
    const Vec3 u = s.radius * along.unitOrthogonal(), v = along.cross(u);
    return coagulated(middle + u) >= kSealed && coagulated(middle - u) >= kSealed &&
           coagulated(middle + v) >= kSealed && coagulated(middle - v) >= kSealed;
  };
  for (VesselInjury& injury : state.injuries) {
    const VesselSegment& s = anatomy.segments[std::size_t(injury.segment)];
    if (s.radius > kWidestSealed) continue;
    if (!(injury.sealed & 1) && welded(s, injury.from)) injury.sealed |= 1;
    if (!(injury.sealed & 2) && welded(s, injury.to)) injury.sealed |= 2;
  }
  std::vector<std::int32_t> near;
  index.near(box, near);
  for (const std::int32_t i : near) {
    const VesselSegment& s = anatomy.segments[std::size_t(i)];
    if (s.radius > kWidestSealed || state.injury(i)) continue;
    const double length = s.length();
    for (double way = 0.5 * kBetween; way < length; way += kBetween) {
      const double share = way / length;
      const bool known = std::ranges::any_of(state.clips, [&](const VesselClip& clip) {
        return clip.segment == i && std::abs(clip.share - share) * length < 0.5 * kBetween;
      });
      if (!known && box.contains(s.at(share)) && welded(s, share)) state.addClip({i, share, true});
    }
  }
}

}  // namespace resect
