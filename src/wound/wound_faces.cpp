#include "wound/wound_faces.h"

#include <algorithm>
#include <limits>

namespace resect {
namespace {

using wound::Gap;
using wound::Ring;
using Vec2 = Eigen::Vector2d;  // in the face

constexpr double kMargin = 0.03;  // points of a face keep away from its border and from nodes

// Position of an edge point of the ring in the face.
Vec2 place(const Ring& ring, int node) {
  const int i = node / 3;
  const CutEdge& e = ring.edge[std::size_t(i)];
  const double t = node % 3 == kIsoNode ? e.iso : e.cut;
  switch (i) {
    case 0:
      return {t, 0};
    case 1:
      return {1, t};
    case 2:
      return {t, 1};
    default:
      return {0, t};
  }
}

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

// Fraction of a..b at which p..q crosses it, both as segments (`within`) or as lines; NaN if they
// do not cross.
double crossing(const Vec2& a, const Vec2& b, const Vec2& p, const Vec2& q, bool within) {
  const Vec2 d = b - a, e = q - p;
  const double scale = cross(d, e);
  const double t = cross(p - a, e) / scale, s = cross(p - a, d) / scale;
  const bool crosses =
      std::abs(scale) > 1e-12 && (!within || (t >= 0 && t <= 1 && s >= 0 && s <= 1));
  return crosses ? t : std::numeric_limits<double>::quiet_NaN();
}

template <typename Visit>
void visitTraces(const CutGrid& grid, int i, int axis, Visit visit) {
  if (grid.wound)
    grid.wound->visitTraces(grid.first + grid.node(i), axis, [&](const FaceTrace& line) {
      visit(Vec2(line.from.cast<double>()), Vec2(line.to.cast<double>()));
    });
}

// The end of a cut that enters the face by one edge only: the blade's farthest point; below the
// surface a..b if that is given.
Vec2 tip(const CutGrid& grid, int i, int axis, const Vec2& from, const Vec2* a, const Vec2* b) {
  Vec2 far = from;
  double farthest = 0;
  visitTraces(grid, i, axis, [&](const Vec2& p, const Vec2& q) {
    for (const Vec2& end : {p, q})
      if ((end - from).squaredNorm() > farthest) {
        farthest = (end - from).squaredNorm();
        far = end;
      }
  });
  if (farthest < kMargin * kMargin) far = from + 0.3 * (Vec2(0.5, 0.5) - from);
  if (a) {
    const double t = crossing(from, far, *a, *b, true);
    if (!std::isnan(t)) far = from + (1 - kMargin) * t * (far - from);
  }
  return far.cwiseMax(kMargin).cwiseMin(1 - kMargin);
}

// The surface's line in the face, from the end of a run to the start of the next one: tissue lies
// to its left. In a face with two such lines, the last of them.
bool skinLine(const Ring& ring, Vec2& a, Vec2& b) {
  for (int g = 0; g < ring.gaps; ++g)
    if (const Gap& gap = ring.gap[std::size_t(g)]; gap.outside) {
      a = place(ring, gap.end);
      b = place(ring, gap.start);
    }
  return ring.outside > 0;
}

bool traceCrosses(const CutGrid& grid, int i, int axis, const Vec2& a, const Vec2& b) {
  bool crosses = false;
  visitTraces(grid, i, axis, [&](const Vec2& p, const Vec2& q) {
    crosses |= !std::isnan(crossing(a, b, p, q, true));
  });
  return crosses;
}

// Where the cut meets the surface a..b, as a fraction of a..b.
double onSkin(const CutGrid& grid, int i, int axis, const Ring& ring, const Vec2& a,
              const Vec2& b) {
  double share = std::numeric_limits<double>::quiet_NaN();
  visitTraces(grid, i, axis, [&](const Vec2& p, const Vec2& q) {
    if (std::isnan(share)) share = crossing(a, b, p, q, true);
  });
  if (std::isnan(share)) {  // opposite the cut edges
    Vec2 middle = Vec2::Zero();
    for (int g = 0; g < ring.gaps; ++g)
      if (!ring.gap[std::size_t(g)].outside)
        middle += place(ring, ring.gap[std::size_t(g)].end) / ring.cuts;
    share = (middle - a).dot(b - a) / std::max((b - a).squaredNorm(), 1e-12);
  }
  return std::clamp(share, kMargin, 1 - kMargin);
}

// Where three or four cuts meet: on the chord between two opposite cut edges, opposite the third.
Vec2 junction(const Ring& ring) {
  std::array<Vec2, 4> cut;
  std::array<bool, 4> has{};
  for (int i = 0; i < 4; ++i)
    if (ring.edge[std::size_t(i)].cutsTissue()) {
      has[std::size_t(i)] = true;
      cut[std::size_t(i)] = place(ring, 3 * i);
    }
  const int through = has[0] && has[2] ? 0 : 1;  // the chord from this edge to the opposite one
  const Vec2 a = cut[std::size_t(through)], b = cut[std::size_t(through + 2)];
  const int c = 1 - through;
  double t;
  if (has[std::size_t(c)] && has[std::size_t(c + 2)])
    t = crossing(a, b, cut[std::size_t(c)], cut[std::size_t(c + 2)], true);
  else
    t = crossing(
        a, b, cut[std::size_t(has[std::size_t(c)] ? c : c + 2)],
        cut[std::size_t(has[std::size_t(c)] ? c : c + 2)] + Vec2::Unit(through == 0 ? 0 : 1),
        false);
  // A chord between edges 0 and 2 runs along v, so the third edge's height along it is its v.
  if (std::isnan(t)) t = 0.5;
  return a + std::clamp(t, kMargin, 1 - kMargin) * (b - a);
}

Vec3 inWindow(const CutGrid& grid, int i, int axis, const Vec2& p) {
  Vec3 where = grid.node(i).cast<double>();
  where[nextAxis(axis)] += p.x();
  where[lastAxis(axis)] += p.y();
  return where;
}

}  // namespace

namespace wound {

Ring ringOf(const CutGrid& grid, int i, int axis) {
  Ring ring;
  const Vec3i n = grid.node(i), u = Vec3i::Unit(nextAxis(axis)), v = Vec3i::Unit(lastAxis(axis));
  const std::array<Vec3i, 4> corner = {Vec3i::Zero(), u, u + v, v};
  std::array<bool, 4> inside;
  int first = -1;
  for (int c = 3; c >= 0; --c) {
    inside[std::size_t(c)] = grid.inside(grid.index(n + corner[std::size_t(c)]));
    if (inside[std::size_t(c)]) first = c;
    const RingEdge e = ringEdge(axis, c);
    ring.edge[std::size_t(c)] = cutEdge(grid, grid.index(n + e.offset), e.axis);
  }
  if (first < 0) return ring;

  NearbyNodes run = 0, head = 0;  // anchors of the present run, and of the first run
  const auto end = [&](int node) {
    (ring.gaps == 0 ? head : ring.gap[std::size_t(ring.gaps - 1)].anchors) |= run;
    ring.gap[std::size_t(ring.gaps)].end = std::uint8_t(node);
  };
  const auto start = [&](int node, bool outside, NearbyNodes anchors) {
    ring.gap[std::size_t(ring.gaps)].start = std::uint8_t(node);
    ring.gap[std::size_t(ring.gaps)].outside = outside;
    ++ring.gaps;
    ++(outside ? ring.outside : ring.cuts);
    run = anchors;
  };
  for (int k = 0; k < 4; ++k) {
    const int c = (first + k) % 4;
    if (inside[std::size_t(c)]) run |= nearbyNode(corner[std::size_t(c)]);
    const CutEdge& e = ring.edge[std::size_t(c)];
    if (e.kind == EdgeKind::None) continue;
    const bool upwards = c < 2;  // edges 2 and 3 are traversed from their upper end
    const int here = 3 * c + (upwards ? kLower : kUpper),
              there = 3 * c + (upwards ? kUpper : kLower);
    const int skin = 3 * c + kIsoNode;
    const bool leaves = inside[std::size_t(c)];
    const NearbyNodes owner =
        e.owner >= 0 ? nearbyNode(Vec3i(grid.node(e.owner) - n)) : NearbyNodes(0);
    if (e.kind == EdgeKind::Sheet) {
      end(here);
      start(there, false, 0);
    } else if (leaves) {
      if (e.kind == EdgeKind::Split) {
        end(here);
        start(there, false, owner);
      }
      end(skin);
    } else {
      start(skin, true, e.kind == EdgeKind::Split ? owner : NearbyNodes(0));
      if (e.kind == EdgeKind::Split) {
        end(here);
        start(there, false, 0);
      }
    }
  }
  if (ring.gaps > 0) ring.gap[std::size_t(ring.gaps - 1)].anchors |= run | head;
  return ring;
}

FaceLines linesOf(const CutGrid& grid, int i, int axis, const Ring& ring, bool skinHolds) {
  FaceLines result;
  if (ring.gaps == 0) return result;
  const auto gap = [&](int g) -> const Gap& { return ring.gap[std::size_t(g % ring.gaps)]; };
  // The gaps that separate the runs; a continuous surface is a line by itself and separates
  // nothing.
  std::array<Gap, FaceLines::kMost> parts;
  int count = 0;
  Vec2 a = Vec2::Zero(), b = Vec2::Zero();  // the surface
  int firstGap = 0;                         // one after an arc, so that its runs are joined below
  for (int g = 0; g < ring.gaps; ++g)
    if (gap(g).outside) {
      a = place(ring, gap(g).end);
      b = place(ring, gap(g).start);
      firstGap = g + 1;
      if (skinHolds) result.line[std::size_t(result.count++)] = {gap(g).end, gap(g).start};
    }
  for (int g = firstGap; g < firstGap + ring.gaps; ++g)
    if (!gap(g).outside || !skinHolds)
      parts[std::size_t(count++)] = gap(g);
    else
      parts[std::size_t(count - 1)].anchors |= gap(g).anchors;

  const bool parted = ring.outside > 0 && !skinHolds;
  if (ring.cuts == 0)
    result.kind = FacePoint::None;
  else if (parted)
    result.kind = FacePoint::Skin;
  else
    result.kind = count == 1 ? FacePoint::Tip : count == 2 ? FacePoint::None : FacePoint::Junction;

  for (int g = 0; g < count; ++g) {
    const Gap& from = parts[std::size_t((g + 1) % count)];
    const Gap& to = parts[std::size_t(g)];
    result.line[std::size_t(result.count++)] = {from.end, to.start, result.kind != FacePoint::None,
                                                to.anchors};
  }
  if (result.kind == FacePoint::None) return result;
  Vec2 point;
  if (result.kind == FacePoint::Tip)
    point = tip(grid, i, axis, place(ring, parts[0].end), skinHolds ? &a : nullptr, &b);
  else if (result.kind == FacePoint::Junction)
    point = junction(ring);
  else
    point = a + onSkin(grid, i, axis, ring, a, b) * (b - a);
  result.point = inWindow(grid, i, axis, point);
  return result;
}

}  // namespace wound

bool skinHolds(const CutGrid& grid, int i, int axis) {
  const Ring ring = wound::ringOf(grid, i, axis);
  for (const CutEdge& e : ring.edge)
    if (e.open) return false;
  Vec2 a, b;
  if (skinLine(ring, a, b) && traceCrosses(grid, i, axis, a, b)) return false;
  int from = -1, to = -1;
  for (int g = 0; g < ring.gaps; ++g)
    if (const Gap& gap = ring.gap[std::size_t(g)]; gap.outside) {
      from = ring.edge[gap.end / 3].owner;
      to = ring.edge[gap.start / 3].owner;
    }
  if (from < 0 || from == to) return true;

  // Flood fill over whole edges within tissue, in the face's two cells and one node round them.
  const Vec3i n = grid.node(i);
  const Vec3i low = (n - Vec3i::Ones() - Vec3i::Unit(axis)).cwiseMax(0);
  const Vec3i high = (n + Vec3i::Constant(2)).cwiseMin(grid.dims - Vec3i::Ones());
  const Vec3i size = high - low + Vec3i::Ones();
  std::array<std::uint8_t, 80> seen{};
  std::array<int, 80> queue;
  int count = 0;
  const auto visit = [&](int node) {
    if (!grid.inside(node)) return;
    const Vec3i d = grid.node(node) - low;
    std::uint8_t& mark = seen[std::size_t((d.z() * size.y() + d.y()) * size.x() + d.x())];
    if (!mark) queue[std::size_t(count++)] = node;
    mark = 1;
  };
  visit(from);
  for (int at = 0; at < count; ++at) {
    const int node = queue[std::size_t(at)];
    if (node == to) return true;
    const Vec3i p = grid.node(node);
    for (int a = 0; a < 3; ++a) {
      const int step = grid.stride(a);
      if (p[a] < high[a] && grid.whole(node, a)) visit(node + step);
      if (p[a] > low[a] && grid.whole(node - step, a)) visit(node - step);
    }
  }
  return false;
}

RingPoint belowShallowCut(const CutGrid& grid, int i, int axis) {
  RingPoint below;
  const Ring ring = wound::ringOf(grid, i, axis);
  Vec2 a, b;
  if (ring.cuts > 0 || ring.outside != 1 || !skinLine(ring, a, b)) return below;
  visitTraces(grid, i, axis, [&](const Vec2& p, const Vec2& q) {
    const double t = crossing(a, b, p, q, true);
    if (below.edge >= 0 || std::isnan(t)) return;
    const Vec2 onSkin = a + t * (b - a);
    const Vec2 inwards = cross(b - a, q - p) > 0 ? Vec2(q - p) : Vec2(p - q);
    const Vec2 beyond = onSkin + 2 * inwards.normalized();
    for (int e = 0; e < 4; ++e) {
      const CutEdge& edge = ring.edge[std::size_t(e)];
      const Vec2 lower(e == 1, e == 2), upper(e != 3, e == 1 || e == 2 || e == 3);
      const double share = crossing(lower, upper, onSkin, beyond, true);
      if (std::isnan(share) || (edge.kind == EdgeKind::None && !edge.lowerInside)) continue;
      if (edge.kind == EdgeKind::Iso && edge.lowerInside != (share < edge.iso)) continue;
      below = {e, share};
    }
  });
  return below;
}

FaceLines faceLines(const CutGrid& grid, int i, int axis) {
  return faceLines(grid, i, axis, [&] { return skinHolds(grid, i, axis); });
}

}  // namespace resect
