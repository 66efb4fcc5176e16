#include "operation/blood/bare_vessels.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/elementary.h"
#include "organ/picture/picture_vessels.h"
#include "tools/rest_place.h"

namespace resect {
namespace {

constexpr int kSides = 10;
constexpr double kRetracts = 1.0e-3;  // m: how far the ends of a divided vessel draw back
constexpr double kClipWidth = 0.8e-3, kClipOver = 1.2e-3;  // m: along the vessel; beyond its wall
constexpr double kMouth = 0.006;  // m: a clip is seen if the vessel's end is this near to it

// Appends a closed prism of these half widths, m, round the way from a to b.
void addPrism(TriangleMesh& mesh, const Vec3& a, const Vec3& b, const Vec3& u, const Vec3& v,
              int sides) {
  const auto first = std::int32_t(mesh.points.size());
  for (const Vec3& end : {a, b})
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 0.5) / sides;
      mesh.points.push_back(end + math::cos(angle) * u + math::sin(angle) * v);
    }
  for (int i = 0; i < sides; ++i) {
    const std::int32_t here = first + i, next = first + (i + 1) % sides;
    mesh.triangles.push_back({here, next, here + sides});
    mesh.triangles.push_back({next, next + sides, here + sides});
  }
  for (int i = 2; i < sides; ++i) {
    mesh.triangles.push_back({first, first + i, first + i - 1});
    mesh.triangles.push_back({first + sides, first + sides + i - 1, first + sides + i});
  }
}

// The axes at right angles to a way, right-handed with it.
std::pair<Vec3, Vec3> across(const Vec3& way) {
  const Vec3 along = way.normalized(), u = along.unitOrthogonal();
  return {u, along.cross(u)};
}

// Appends a closed tube from a to b. Its ends are half balls, so that the pieces of a vessel join
// smoothly; if cutA or cutB, this end is flat.
void addTube(TriangleMesh& mesh, const Vec3& a, const Vec3& b, double radius, bool cutA = false,
             bool cutB = false) {
  if ((b - a).norm() < 1e-5) return;
  const Vec3 along = (b - a).normalized();
  const auto [u, v] = across(b - a);
  const auto first = std::int32_t(mesh.points.size());
  const auto addRing = [&](const Vec3& centre, double r) {
    for (int i = 0; i < kSides; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 0.5) / kSides;
      mesh.points.push_back(centre + r * (math::cos(angle) * u + math::sin(angle) * v));
    }
  };
  // Rings of an end, from the equator to near the pole: distance from the end and radius, as shares
  // of the tube's radius.
  constexpr double kEnd[][2] = {{0, 1}, {0.5, 0.866}, {0.866, 0.5}};
  const int ringsA = cutA ? 1 : int(std::size(kEnd)), ringsB = cutB ? 1 : int(std::size(kEnd));
  for (int k = ringsA; k-- > 0;) addRing(a - kEnd[k][0] * radius * along, kEnd[k][1] * radius);
  for (int k = 0; k < ringsB; ++k) addRing(b + kEnd[k][0] * radius * along, kEnd[k][1] * radius);
  const int rings = ringsA + ringsB;
  const auto poleA = std::int32_t(mesh.points.size()), poleB = poleA + 1;
  mesh.points.push_back(cutA ? a : Vec3(a - radius * along));
  mesh.points.push_back(cutB ? b : Vec3(b + radius * along));
  for (int i = 0; i < kSides; ++i) {
    const int next = (i + 1) % kSides;
    mesh.triangles.push_back({poleA, first + next, first + i});
    for (int k = 0; k + 1 < rings; ++k) {
      const std::int32_t low = first + k * kSides, high = low + kSides;
      mesh.triangles.push_back({low + i, low + next, high + i});
      mesh.triangles.push_back({low + next, high + next, high + i});
    }
    const std::int32_t last = first + (rings - 1) * kSides;
    mesh.triangles.push_back({poleB, last + i, last + next});
  }
}

// The lumen at a cut end, a thin disc before the end's flat face. outwards: unit.
void addMouth(TriangleMesh& mesh, const Vec3& end, const Vec3& outwards, double radius) {
  constexpr double kThick = 0.05e-3;  // m
  const auto [u, v] = across(outwards);
  addPrism(mesh, end, end + kThick * outwards, radius * u, radius * v, kSides);
}

// Where a clip is on its vessel, if it is to be seen: on a bare vessel, or near an end.
bool isSeen(const Organ& organ, const VesselClip& clip) {
  if (std::ranges::binary_search(organ.vessels.bared, clip.segment)) return true;
  const VesselInjury* injury = organ.vessels.injury(clip.segment);
  if (!injury) return false;
  const double length = organ.map->anatomy.segments[std::size_t(clip.segment)].length();
  return std::min(std::abs(clip.share - injury->from), std::abs(clip.share - injury->to)) * length <
         kMouth;
}

void addOrgan(BareVessels& all, const OperatedOrgan& operated) {
  const Organ& organ = operated.organ;
  if (!organ.map) return;
  const auto placed = [&](const VesselSegment& s, double share) {
    return presentPlace(organ, *operated.tissue, s.at(share));
  };
  for (const std::int32_t i : organ.vessels.bared) {
    const VesselSegment& s = organ.map->anatomy.segments[std::size_t(i)];
    const double outside = s.radius + wallOf(s.kind, s.radius), gap = kRetracts / s.length();
    TriangleMesh& mesh = all.tubes[std::size_t(s.kind)];
    const VesselInjury* injury = organ.vessels.injury(i);
    if (!injury || !injury->severed()) {
      addTube(mesh, placed(s, 0), placed(s, 1), outside);
      continue;
    }
    if (injury->from > gap) {
      const Vec3 a = placed(s, 0), b = placed(s, injury->from - gap);
      addTube(mesh, a, b, outside, false, true);
      addMouth(all.mouths, b, (b - a).normalized(), s.radius);
    }
    if (injury->to < 1 - gap) {
      const Vec3 a = placed(s, injury->to + gap), b = placed(s, 1);
      addTube(mesh, a, b, outside, true, false);
      addMouth(all.mouths, a, (a - b).normalized(), s.radius);
    }
  }
  for (const VesselClip& clip : organ.vessels.clips) {
    if (!isSeen(organ, clip)) continue;
    const VesselSegment& s = organ.map->anatomy.segments[std::size_t(clip.segment)];
    const double half = 0.5 * (clip.byHeat ? 1.5e-3 : kClipWidth) / s.length();
    const Vec3 a = placed(s, clip.share - half), b = placed(s, clip.share + half);
    if ((b - a).norm() < 1e-5) continue;
    const double outside = s.radius + wallOf(s.kind, s.radius);
    const auto [u, v] = across(b - a);
    if (clip.byHeat)
      addPrism(all.sealed, a, b, 1.08 * outside * u, 1.08 * outside * v, kSides);
    else  // flat and longer than the vessel is wide
      addPrism(all.clips, a, b, (1.6 * outside + kClipOver) * u, (0.5 * outside + 0.6e-3) * v, 4);
  }
}

}  // namespace

std::shared_ptr<const BareVessels> bareVessels(const Simulation& simulation) {
  const bool any = std::ranges::any_of(simulation.organs(), [](const OperatedOrgan& o) {
    return !o.organ.vessels.bared.empty() || !o.organ.vessels.clips.empty();
  });
  if (!any) return nullptr;
  auto all = std::make_shared<BareVessels>();
  for (const OperatedOrgan& o : simulation.organs()) addOrgan(*all, o);
  for (const TriangleMesh& mesh : all->tubes)
    for (const Vec3& p : mesh.points) all->box.grow(p);
  for (const TriangleMesh* mesh : {&all->mouths, &all->sealed, &all->clips})
    for (const Vec3& p : mesh->points) all->box.grow(p);
  return all;
}

}  // namespace resect
