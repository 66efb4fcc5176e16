#include "operation/blood/bare_vessels.h"

#include <algorithm>
#include <cmath>

#include "operation/blood/vessel_walls.h"
#include "organ/picture/picture_vessels.h"
#include "tools/rest_place.h"

namespace resect {
namespace {

constexpr double kRetracts = 1.0e-3;  // m: how far the ends of a divided vessel draw back
constexpr double kMouth = 0.006;      // m: a clip is seen if the vessel's end is this near to it
constexpr double kStump = 0.0025;     // m: of a terminal branch, with 1.5 times its radius

double outsideOf(const VesselSegment& s) { return s.radius + wallOf(s.kind, s.radius); }

// Where a clip is on its vessel, if it is to be seen: on a bare vessel, or near an end.
bool isSeen(const Organ& organ, const VesselClip& clip) {
  if (std::ranges::binary_search(organ.vessels.bared, clip.segment)) return true;
  const VesselInjury* injury = organ.vessels.injury(clip.segment);
  if (!injury) return false;
  const double length = organ.map->anatomy.segments[std::size_t(clip.segment)].length();
  return std::min(std::abs(clip.share - injury->from), std::abs(clip.share - injury->to)) * length <
         kMouth;
}

// The vessels that are drawn, as smooth ways: at a fork the widest branch goes on in the direction
// of its parent, and the others bend away from it.
class VesselTree {
 public:
  VesselTree(const OperatedOrgan& operated, const std::vector<std::int32_t>& drawn)
      : operated_(operated),
        segments_(operated.organ.map->anatomy.segments),
        drawn_(drawn),
        widest_(drawn_.size(), -1) {
    for (const std::int32_t i : drawn_)
      if (const std::ptrdiff_t above = numberOf(segments_[std::size_t(i)].parent); above >= 0) {
        std::int32_t& kept = widest_[std::size_t(above)];
        if (kept < 0 || segment(kept).radius < segment(i).radius) kept = i;
      }
  }

  // The whole wall of a segment, with its ends covered. torn: only a stump of it is left.
  VesselWall wholeWall(std::int32_t number, bool torn = false) const {
    VesselSegment s = segment(number);
    if (torn)
      s.end =
          s.start + std::min(1.0, (kStump + 1.5 * outsideOf(s)) / s.length()) * (s.end - s.start);
    VesselWall wall;
    wall.kind = s.kind;
    wall.lumen = s.radius;
    wall.outside = wall.outsideA = wall.outsideB = outsideOf(s);
    Vec3 before = s.end - s.start, after = before;
    if (s.parent >= 0) {
      const VesselSegment& parent = segment(s.parent);
      const std::ptrdiff_t above = numberOf(s.parent);
      const bool goesOn = above < 0 || widest_[std::size_t(above)] == number;
      before = between(parent.end - parent.start, s.end - s.start, goesOn ? 1 : 0.5);
      const double parents = outsideOf(parent);
      if (above >= 0)
        wall.outsideA =
            goesOn ? 0.5 * (wall.outside + parents) : std::min(parents, 1.3 * wall.outside);
    }
    if (const std::ptrdiff_t here = numberOf(number);
        here >= 0 && widest_[std::size_t(here)] >= 0) {
      const VesselSegment& next = segment(widest_[std::size_t(here)]);
      after = between(next.end - next.start, s.end - s.start, 1);
      wall.outsideB = 0.5 * (wall.outside + outsideOf(next));
    }
    if (s.leaf) wall.outsideB = 0.45 * wall.outside;
    const double length = s.length();
    wall.rest = {s.start, s.end, length * before.normalized(), length * after.normalized()};
    wall.present = placed(wall.rest);
    return wall;
  }

  const VesselSegment& segment(std::int32_t number) const { return segments_[std::size_t(number)]; }

 private:
  std::ptrdiff_t numberOf(std::int32_t segment) const {
    const auto at = std::ranges::lower_bound(drawn_, segment);
    return at != drawn_.end() && *at == segment ? at - drawn_.begin() : -1;
  }
  // other, own: directions. share: how much of the other one counts.
  static Vec3 between(const Vec3& other, const Vec3& own, double share) {
    const Vec3 sum = own.normalized() + share * other.normalized();
    return sum.norm() > 0.5 ? sum : own;
  }
  SmoothWay placed(const SmoothWay& rest) const {
    const auto at = [&](const Vec3& p) {
      return presentPlace(operated_.organ, *operated_.tissue, p);
    };
    SmoothWay way;
    way.a = at(rest.a), way.b = at(rest.b);
    // The slopes turn with the way, so that they need no places of their own.
    const Vec3 restWay = rest.b - rest.a, presentWay = way.b - way.a;
    const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(restWay, presentWay);
    const double longer = presentWay.norm() / std::max(restWay.norm(), 1e-9);
    way.slopeA = longer * (turn * rest.slopeA), way.slopeB = longer * (turn * rest.slopeB);
    return way;
  }

  const OperatedOrgan& operated_;
  const std::vector<VesselSegment>& segments_;
  const std::vector<std::int32_t>& drawn_;
  std::vector<std::int32_t> widest_;  // for each drawn segment: its widest drawn branch; -1: none
};

// Whether a terminal branch was torn from the tissue that it supplied, so that a stump is left.
// Such a branch has no end of its own: where it ends, the smallest vessels begin.
bool isTorn(const Organ& organ, std::int32_t number) {
  const VesselSegment& s = organ.map->anatomy.segments[std::size_t(number)];
  if (!s.leaf || organ.vessels.injury(number)) return false;
  if (std::ranges::binary_search(organ.vessels.clips, number, {}, &VesselClip::segment))
    return false;
  const Lattice& lattice = organ.rest.lattice;
  const std::optional<Vec3i> cell = lattice.cellAt(s.end);
  return !cell || !organ.alive[std::size_t(lattice.index(*cell))];
}

// The segments whose walls are drawn: the bare ones, and those that go on from them. Cells are far
// larger than vessels, so the tissue may not cover the place where a vessel ceases to be bare.
// Ascending.
std::vector<std::int32_t> drawnSegments(const Organ& organ) {
  constexpr double kThinnest = 0.3e-3;  // m: radius below which a vessel is not followed
  const std::vector<VesselSegment>& segments = organ.map->anatomy.segments;
  const std::vector<std::int32_t>& bared = organ.vessels.bared;
  std::vector<std::int32_t> drawn = bared;
  const auto follow = [&](std::int32_t i) {
    const auto part = std::ranges::lower_bound(organ.vessels.apart, i, {}, &SegmentPart::segment);
    const bool lost = part != organ.vessels.apart.end() && part->segment == i;
    if (!lost && segments[std::size_t(i)].radius >= kThinnest) drawn.push_back(i);
  };
  std::vector<std::uint8_t> isBare(segments.size() + 1,
                                   0);  // number -1, no parent, is the last one
  const auto at = [&](std::int32_t i) { return i < 0 ? segments.size() : std::size_t(i); };
  for (const std::int32_t i : bared) {
    isBare[at(i)] = 1;
    if (segments[at(i)].parent >= 0) follow(segments[at(i)].parent);
  }
  // A branch comes after its parent.
  for (std::size_t i = bared.empty() ? segments.size() : at(bared.front()); i < segments.size();
       ++i)
    if (isBare[at(segments[i].parent)]) follow(std::int32_t(i));
  std::ranges::sort(drawn);
  drawn.erase(std::ranges::unique(drawn).begin(), drawn.end());
  return drawn;
}

void addOrgan(BareVessels& all, const OperatedOrgan& operated) {
  const Organ& organ = operated.organ;
  if (!organ.map) return;
  const std::vector<std::int32_t> drawn = drawnSegments(organ);
  const VesselTree tree(operated, drawn);
  const auto& clips = organ.vessels.clips;
  for (const std::int32_t i : drawn) {
    const auto [first, last] = std::ranges::equal_range(clips, i, {}, &VesselClip::segment);
    const VesselInjury* injury = organ.vessels.injury(i);
    VesselWall wall = tree.wholeWall(i, isTorn(organ, i));
    const double gap = kRetracts / tree.segment(i).length();
    for (auto clip = first; clip != last; ++clip)
      wall.pinches.push_back({clip->share, clip->byHeat});
    if (!injury || !injury->severed()) {
      addWall(all.walls, wall);
      continue;
    }
    const auto endOf = [&](VesselEnd end) {
      return injury->isSealed(end) ? WallEnd::Sealed : WallEnd::Open;
    };
    if (injury->from > gap) {
      VesselWall part = wall;
      part.to = injury->from - gap, part.atTo = endOf(VesselEnd::Root);
      addWall(all.walls, part);
    }
    if (injury->to < 1 - gap) {
      wall.from = injury->to + gap, wall.atFrom = endOf(VesselEnd::Far);
      addWall(all.walls, wall);
    }
  }
  for (const VesselClip& clip : clips) {
    if (clip.byHeat || !isSeen(organ, clip)) continue;
    const VesselWall wall = tree.wholeWall(clip.segment);
    const Vec3 along = wall.present.direction(clip.share),
               restAlong = wall.rest.direction(clip.share);
    const Vec3 u = across(along, across(restAlong, restAlong.unitOrthogonal()).first).first;
    addClip(all.clips, all.clipNormals, wall.present.at(clip.share), along, u, wall.outside);
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
  for (const Vec3f& p : all->walls.points) all->box.grow(p.cast<double>());
  for (const Vec3& p : all->clips.points) all->box.grow(p);
  return all;
}

}  // namespace resect
