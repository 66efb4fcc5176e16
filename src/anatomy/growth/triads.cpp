#include "anatomy/growth/triads.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "anatomy/growth/detour.h"
#include "base/elementary.h"

namespace resect {
namespace {

constexpr double kMostTurn = 0.5236;  // rad, 30 degrees: of a piece about the vein
constexpr double kAway = 1.04;        // a chord of that turn is nearer to the vein than its ends
constexpr double kApart = 0.5e-4;     // m: least gap between vessels
constexpr double kThinnestBranch = 0.5e-4;  // m: radius below which a branch ends
constexpr double kLongestPiece = 0.006;     // m: of a piece
constexpr double kBelowSurface = 3e-4;      // m
constexpr double kShallow = 3;  // radii: where the vein is less deep, both run level with it
constexpr double kLook = 5e-4;  // m: steps along a piece, to look at its depth
constexpr int kRounds = 40;     // of pushing aside
constexpr int kPasses = 3;
constexpr double kNarrower[] = {1, 0.6,
                                0.3};  // of its radius, for a piece that is led round others

// Across the direction, as near to `wanted` as can be.
Vec3 across(const Vec3& direction, const Vec3& wanted) {
  Vec3 n = wanted - direction.dot(wanted) * direction;
  if (n.norm() < 1e-3 * std::max(wanted.norm(), 1e-12)) {
    const Vec3 axis = std::abs(direction.x()) < 0.7 ? Vec3::UnitX() : Vec3::UnitY();
    n = direction.cross(axis);
  }
  return n.normalized();
}

Aabb boxOf(const VesselSegment& s) {
  Aabb box;
  box.grow(s.start);
  box.grow(s.end);
  return box;
}

Vec3 directionOf(const VesselSegment& s) { return (s.end - s.start).normalized(); }

// For each segment of the portal vein, the side of its end on which the artery runs: across the
// segment, and across those that follow, as well as that goes.
std::vector<Vec3> sides(std::span<const VesselSegment> veins, const OrganInside& inside) {
  std::vector<std::vector<std::size_t>> children(veins.size());
  for (std::size_t i = 0; i < veins.size(); ++i)
    if (veins[i].parent >= 0) children[std::size_t(veins[i].parent)].push_back(i);
  std::vector<Vec3> side(veins.size());
  for (std::size_t i = 0; i < veins.size(); ++i) {
    const Vec3 along = directionOf(veins[i]);
    const Vec3 before = veins[i].parent >= 0 ? across(along, side[std::size_t(veins[i].parent)])
                                             : across(along, Vec3::UnitY());
    const Vec3 level = along.cross(inside.inwards(veins[i].end));
    Vec3 wanted = before;
    if (children[i].size() >= 2)
      wanted = directionOf(veins[children[i][0]]).cross(directionOf(veins[children[i][1]]));
    else if (children[i].size() == 1)
      wanted = along.cross(directionOf(veins[children[i][0]]));
    if (inside.depth(veins[i].end) < kShallow * veins[i].radius) wanted = level;
    Vec3 n = wanted.norm() > 0.1 ? across(along, wanted) : before;
    if (n.dot(before) < 0) n = -n;
    side[i] = n;
  }
  return side;
}

// The branch beside each vein: pieces that turn about the vein from its start's side to its end's.
std::vector<VesselSegment> beside(std::span<const VesselSegment> veins, std::span<const Vec3> side,
                                  VesselKind kind, double share, double sign, double gap) {
  std::vector<VesselSegment> tree;
  std::vector<std::int32_t> last(veins.size());
  const auto away = [&](double r) { return kAway * (r * (1 + share) + gap); };
  for (std::size_t i = 0; i < veins.size(); ++i) {
    const VesselSegment& vein = veins[i];
    const Vec3 along = directionOf(vein), to = across(along, side[i]);
    const bool root = vein.parent < 0;
    const Vec3 from = root ? to : side[std::size_t(vein.parent)];
    const double r0 = root ? vein.radius : veins[std::size_t(vein.parent)].radius;
    const Vec3 flat = across(along, from);
    const double angle = math::atan2(along.dot(flat.cross(to)), flat.dot(to));
    const int pieces =
        1 + std::max(int(std::abs(angle) / kMostTurn), int(vein.length() / kLongestPiece));
    std::int32_t parent = root ? -1 : last[std::size_t(vein.parent)];
    Vec3 start = root ? Vec3(vein.start + sign * away(r0) * from) : tree[std::size_t(parent)].end;
    for (int k = 1; k <= pieces; ++k) {
      const double t = double(k) / pieces;
      const Vec3 n = math::cos(t * angle) * flat + math::sin(t * angle) * along.cross(flat);
      const double r = std::max(vein.radius, r0 + t * (vein.radius - r0));
      const Vec3 end = vein.at(t) + sign * away(r) * n;
      tree.push_back({kind, parent, start, end, share * vein.radius, vein.leaf && k == pieces});
      parent = std::int32_t(tree.size()) - 1;
      start = end;
    }
    last[i] = parent;
  }
  return tree;
}

// Pushes the tree out of the way of `others`, and below the organ's surface. Where a piece is too
// near to another vessel, its ends move apart from it, the nearer end more; so it passes on the
// side on which it was.
void pushAside(std::vector<VesselSegment>& tree, std::span<const VesselSegment> others,
               const VesselIndex& index, const OrganInside& inside) {
  std::vector<std::int32_t> near;
  // Where each piece was when it was looked at and did not move: there it need not be looked at
  // again.
  const Vec3 nowhere = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  std::vector<std::pair<Vec3, Vec3>> settled(tree.size(), {nowhere, nowhere});
  const auto move = [&](std::size_t i, double atStart, double atEnd, const Vec3& by) {
    // The least motion of both ends that moves the place between them by `by`.
    const bool root = tree[i].parent < 0;
    const double weight = (root ? 0 : atStart * atStart) + atEnd * atEnd;
    if (weight < 0.01) return;
    if (!root) tree[std::size_t(tree[i].parent)].end += atStart / weight * by;
    tree[i].end += atEnd / weight * by;
  };
  for (int round = 0; round < kRounds; ++round) {
    bool any = false;
    for (std::size_t i = 0; i < tree.size(); ++i) {
      VesselSegment& s = tree[i];
      if (s.parent >= 0) s.start = tree[std::size_t(s.parent)].end;
      const std::pair<Vec3, Vec3> before(s.start, s.end);
      if (before == settled[i]) continue;
      index.near(boxOf(s).padded(s.radius + kApart), near);
      for (const std::int32_t j : near) {
        const VesselSegment& o = others[std::size_t(j)];
        const double wanted = s.radius + o.radius + 2 * kApart;
        if (!meets(boxOf(s).padded(wanted), boxOf(o))) continue;
        const NearestPlaces n = nearestPlaces(s.start, s.end, o.start, o.end);
        Vec3 out = s.at(n.first) - o.at(n.second);
        const double d = out.norm();
        if (d >= wanted) continue;
        any = true;
        if (d < 1e-7) out = across(directionOf(o), (s.end - s.start).cross(o.end - o.start));
        move(i, 1 - n.first, n.first, (wanted - d) * out.normalized());
        if (s.parent >= 0) s.start = tree[std::size_t(s.parent)].end;
      }
      for (const double t : {0.5, 1.0}) {
        const Vec3 p = s.at(t);
        const double low = s.radius + kBelowSurface - inside.depth(p);
        if (s.parent < 0 || low <= 0) continue;
        move(i, 1 - t, t, low * inside.inwards(p));
        s.start = tree[std::size_t(s.parent)].end;
        any = true;
      }
      if (before == std::pair(s.start, s.end)) settled[i] = before;
    }
    if (!any) break;
  }
  for (VesselSegment& s : tree)
    if (s.parent >= 0) s.start = tree[std::size_t(s.parent)].end;
}

// Halves pieces that have become long.
void halveLong(std::vector<VesselSegment>& tree) {
  std::vector<VesselSegment> halved;
  std::vector<std::int32_t> number(tree.size());
  for (std::size_t i = 0; i < tree.size(); ++i) {
    VesselSegment s = tree[i];
    if (s.parent >= 0) s.parent = number[std::size_t(s.parent)];
    if (s.parent >= 0 && s.length() > kLongestPiece) {
      VesselSegment first = s;
      first.end = s.at(0.5);
      first.leaf = false;
      s.start = first.end;
      s.parent = std::int32_t(halved.size());
      halved.push_back(first);
    }
    number[i] = std::int32_t(halved.size());
    halved.push_back(s);
  }
  tree = std::move(halved);
}

struct Kept {
  std::vector<VesselSegment> tree;
  std::vector<char> within;  // by segment: it or one before it has come into the organ
};

// Appends the piece, narrowed where it is too near to another vessel or to the organ's surface.
// Returns false if it has no room.
bool keep(VesselSegment s, const Surroundings& around, Kept& kept) {
  const bool within = s.parent >= 0 && kept.within[std::size_t(s.parent)];
  const bool comesIn = around.inside.depth(s.end) >= s.radius;
  std::vector<std::int32_t> near;  // outside the organ vessels may meet
  if (within || comesIn) around.index.near(boxOf(s).padded(s.radius + kApart), near);
  for (const std::int32_t j : near) {
    const VesselSegment& o = around.others[std::size_t(j)];
    s.radius =
        std::min(s.radius, segmentDistance(s.start, s.end, o.start, o.end) - o.radius - kApart);
  }
  const int steps = within ? 1 + int(s.length() / kLook) : 0;
  for (int k = 1; k <= steps; ++k)
    s.radius = std::min(s.radius, around.inside.depth(s.at(double(k) / steps)) - kApart);
  if (s.radius < kThinnestBranch) return false;
  kept.tree.push_back(s);
  kept.within.push_back(within || comesIn);
  return true;
}

// Appends pieces that lead round what is in the piece's way, as wide as can be.
bool keepRound(const VesselSegment& s, const Surroundings& around, Kept& kept) {
  const std::size_t before = kept.tree.size();
  for (const double share : kNarrower) {
    const double radius = std::max(share * s.radius, 2 * kThinnestBranch);
    const std::vector<Vec3> way = detour(s.start, s.end, radius, kLongestPiece, around);
    VesselSegment piece = s;
    bool whole = way.size() > 1;
    for (std::size_t k = 1; k < way.size() && whole; ++k) {
      piece.start = way[k - 1], piece.end = way[k];
      whole = keep(piece, around, kept);
      piece.parent = std::int32_t(kept.tree.size()) - 1;
    }
    if (whole) return true;
    kept.tree.resize(before);
    kept.within.resize(before);
  }
  return false;
}

// Narrows pieces that are still too near to another vessel, and leads those without any room round
// it; what cannot be led round is dropped, with all that follows.
std::vector<VesselSegment> withRoom(const std::vector<VesselSegment>& tree,
                                    const Surroundings& around) {
  Kept kept;
  std::vector<std::int32_t> number(tree.size(), -1);
  for (std::size_t i = 0; i < tree.size(); ++i) {
    VesselSegment s = tree[i];
    const bool root = s.parent < 0;
    if (!root) {
      s.parent = number[std::size_t(s.parent)];
      if (s.parent < 0) continue;
      s.start = kept.tree[std::size_t(s.parent)].end;
      if (s.length() < 1e-6) {
        number[i] = s.parent;
        continue;
      }
    }
    if (keep(s, around, kept) || (!root && keepRound(s, around, kept)))
      number[i] = std::int32_t(kept.tree.size()) - 1;
  }
  // A branch whose followers were all dropped feeds the sinusoids where it ends.
  for (VesselSegment& s : kept.tree) s.leaf = true;
  for (const VesselSegment& s : kept.tree)
    if (s.parent >= 0) kept.tree[std::size_t(s.parent)].leaf = false;
  return std::move(kept.tree);
}

}  // namespace

void addTriads(std::vector<VesselSegment>& segments, const VesselGrowth& settings,
               const OrganInside& inside) {
  std::vector<VesselSegment> veins;
  for (const VesselSegment& s : segments)
    if (s.kind == VesselKind::PortalVein) veins.push_back(s);
  const std::vector<Vec3> side = sides(veins, inside);
  const std::pair<VesselKind, double> trees[] = {{VesselKind::HepaticArtery, settings.arteryShare},
                                                 {VesselKind::BileDuct, settings.ductShare}};
  double sign = 1;
  for (const auto& [kind, share] : trees) {
    if (std::ranges::count(segments, kind, &VesselSegment::kind) > 0) continue;  // it was given
    std::vector<VesselSegment> tree = beside(veins, side, kind, share, sign, 0.25 * settings.gap);
    const VesselIndex index(segments);
    for (int pass = 0; pass < kPasses; ++pass) {
      pushAside(tree, segments, index, inside);
      halveLong(tree);
    }
    pushAside(tree, segments, index, inside);
    tree = withRoom(tree, {segments, index, inside, kApart, kBelowSurface});
    const std::int32_t first = std::int32_t(segments.size());
    for (VesselSegment s : tree) {
      if (s.parent >= 0) s.parent += first;
      segments.push_back(s);
    }
    sign = -sign;
  }
}

}  // namespace resect
