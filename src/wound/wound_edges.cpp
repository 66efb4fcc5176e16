#include "wound/wound_edges.h"

#include <algorithm>
#include <limits>

#include "isosurface/brick_mesher.h"

namespace resect {
namespace {

constexpr float kThinnest = 0.04f;  // shortest piece between cut and surface that is drawn

// Whether the face's corners are alternately inside and outside: then a piece of an edge could
// belong to either inside corner.
bool ambiguous(const CutGrid& grid, const Vec3i& n, int axis) {
  const Vec3i u = Vec3i::Unit(nextAxis(axis)), v = Vec3i::Unit(lastAxis(axis));
  if (!grid.contains(n) || !grid.contains(n + u + v)) return false;
  const bool a = grid.inside(grid.index(n));
  return grid.inside(grid.index(n + u)) != a && grid.inside(grid.index(n + u + v)) == a &&
         grid.inside(grid.index(n + v)) != a;
}

bool besideAmbiguousFace(const CutGrid& grid, const Vec3i& n, int axis) {
  const int u = nextAxis(axis), v = lastAxis(axis);
  return ambiguous(grid, n, v) || ambiguous(grid, n - Vec3i::Unit(u), v) || ambiguous(grid, n, u) ||
         ambiguous(grid, n - Vec3i::Unit(v), u);
}

// The inside corner nearest to the edge's outside end that can be reached from there through
// outside corners over whole edges, within the edge's two planes of nodes and one node aside; -1
// when there is none but the edge's own.
int findOwner(const CutGrid& grid, const Vec3i& outside, const Vec3i& own, int axis) {
  const Vec3i aside = Vec3i::Ones() - Vec3i::Unit(axis);
  const Vec3i low = (outside.cwiseMin(own) - aside).cwiseMax(0);
  const Vec3i high = (outside.cwiseMax(own) + aside).cwiseMin(grid.dims - Vec3i::Ones());
  Vec3i queue[18];
  std::uint32_t seen = 0;
  int count = 0, best = -1, bestDistance = std::numeric_limits<int>::max();
  const auto visit = [&](const Vec3i& n) {
    const Vec3i d = n - low;
    const std::uint32_t bit = 1u << ((d.z() * 3 + d.y()) * 3 + d.x());
    if (!(seen & bit)) queue[count++] = n;
    seen |= bit;
  };
  visit(outside);
  for (int at = 0; at < count; ++at) {
    const Vec3i n = queue[at];
    const int i = grid.index(n);
    if (grid.inside(i)) {
      const int distance = (n - outside).squaredNorm();
      if (n != own && (distance < bestDistance || (distance == bestDistance && i < best))) {
        best = i;
        bestDistance = distance;
      }
      continue;
    }
    for (int a = 0; a < 3; ++a) {
      if (n[a] < high[a] && grid.whole(i, a)) visit(n + Vec3i::Unit(a));
      if (n[a] > low[a] && grid.whole(i - grid.stride(a), a)) visit(n - Vec3i::Unit(a));
    }
  }
  return best;
}

}  // namespace

CutEdge cutEdge(const CutGrid& grid, int i, int axis) {
  CutEdge e;
  const int j = i + grid.stride(axis);
  e.lowerInside = grid.inside(i);
  e.cut = grid.severed[std::size_t(axis)][i];
  const bool upperInside = grid.inside(j), severed = e.cut != kWhole;
  if (e.lowerInside == upperInside) {
    e.kind = severed && e.lowerInside ? EdgeKind::Sheet : EdgeKind::None;
    e.open = severed && !e.lowerInside;
    return e;
  }
  e.kind = EdgeKind::Iso;
  e.iso = std::clamp((grid.iso - grid.value[i]) / (grid.value[j] - grid.value[i]), kEndMargin,
                     1 - kEndMargin);
  e.owner = e.lowerInside ? i : j;
  if (!severed) return e;
  const float skin = e.lowerInside ? e.iso - e.cut : e.cut - e.iso;  // length from cut to surface
  if (skin <= kThinnest) {
    e.open = true;
    return e;
  }
  const Vec3i n = grid.node(i), up = n + Vec3i::Unit(axis);
  if (besideAmbiguousFace(grid, n, axis)) return e;
  const int owner = e.lowerInside ? findOwner(grid, up, n, axis) : findOwner(grid, n, up, axis);
  if (owner < 0) return e;
  e.kind = EdgeKind::Split;
  e.owner = owner;
  return e;
}

bool cutsTissue(const CutGrid& grid, int i, int axis) {
  if (grid.whole(i, axis)) return false;
  const bool lower = grid.inside(i), upper = grid.inside(i + grid.stride(axis));
  return lower == upper ? lower : cutEdge(grid, i, axis).kind == EdgeKind::Split;
}

}  // namespace resect
