#include "wound/blade_raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "wound/brick_window.h"
#include "wound/wound_faces.h"

namespace resect {
namespace {

constexpr double kOnPlane = 1e-12;       // m, as in collision/swept_blade.cpp
constexpr double kBorder = 1e-9;         // m
constexpr double kThinnestPiece = 0.05;  // more than is left out (kThinnest in wound_edges.cpp)
constexpr double kShortestTrace = 1e-6;  // node spacings
constexpr int kRasterSide = 5;
constexpr int kStep[3] = {1, kRasterSide, kRasterSide* kRasterSide};
constexpr int kPlacedNodes =
    kRasterSide * kRasterSide * kRasterSide;  // on which a brick's edges and faces lie
using Vec2 = Eigen::Vector2d;

// A face in which the blade left a trace.
struct CrossedFace {
  Vec3i node;  // of the brick
  int axis;
  Vec3 normal;  // of the blade
};

int at(const Vec3i& n) { return (n.z() * kRasterSide + n.y()) * kRasterSide + n.x(); }

// The nodes of a brick: positions, and heights above one of the blade's triangles.
struct GridBrick {
  Vec3i first;
  std::array<Vec3, kPlacedNodes> place;
  std::array<double, kPlacedNodes> height;
  const ColourField* field;
  float iso;
  CutsBetweenCells cuts;
  std::vector<CrossedFace> crossed;

  bool above(int i) const { return height[std::size_t(i)] >= -kOnPlane; }
  Aabb bounds() const { return {place.front(), place.back()}; }
  Aabb cell(const Vec3i& n) const {  // bounds of the cell at the brick's node n
    return {place[std::size_t(at(n))], place[std::size_t(at(n + Vec3i::Ones()))]};
  }
};

// Fraction of the way from i to j at which the triangle's plane is met.
double planeShare(const GridBrick& b, int i, int j) {
  const double from = b.height[std::size_t(i)], to = b.height[std::size_t(j)];
  return std::clamp(from / (from - to), 0.0, 1.0);
}

// Barycentric coordinates, each >= 0 inside.
Vec3 inTriangle(const BladeTriangle& t, const Vec3& p) {
  const double u = t.alongU.dot(p - t.corner), v = t.alongV.dot(p - t.corner);
  return {u, v, 1 - u - v};
}

bool mayBeSevered(const SeveredEdges& severed, CutsBetweenCells cuts, const Vec3i& node, int axis) {
  return cuts == CutsBetweenCells::Any || !severed.betweenCells(node, axis);
}

// The surface of a wound leaves out a piece of an edge that is thinner than kThinnestPiece (as a
// fraction of the edge): a cut that would leave such a piece below the skin goes deeper.
double notTooThin(const ColourField& field, float iso, const Vec3i& node, int axis, double share) {
  const float lower = field.node(node), upper = field.node(node + Vec3i::Unit(axis));
  if ((lower >= iso) == (upper >= iso)) return share;
  const double skin = (iso - lower) / (upper - lower);
  if (lower >= iso) return share < skin ? std::min(share, skin - kThinnestPiece) : share;
  return share > skin ? std::max(share, skin + kThinnestPiece) : share;
}

void severEdge(SeveredEdges& severed, const GridBrick& b, const BladeTriangle& t, const Vec3i& n,
               int axis) {
  const int i = at(n), j = i + kStep[axis];
  if (b.above(i) == b.above(j)) return;
  if (!mayBeSevered(severed, b.cuts, b.first + n, axis)) return;
  const double share = planeShare(b, i, j);
  const Vec3 p =
      b.place[std::size_t(i)] + share * (b.place[std::size_t(j)] - b.place[std::size_t(i)]);
  if (inTriangle(t, p).minCoeff() < -kBladeReach) return;
  severed.sever(b.first + n, axis, notTooThin(*b.field, b.iso, b.first + n, axis, share), t.normal);
}

// The trace on half of a face.
void traceHalf(SeveredEdges& severed, GridBrick& b, const BladeTriangle& t, const Vec3i& n,
               int axis, const std::array<Vec2, 3>& corners) {
  std::array<int, 3> index;
  for (std::size_t c = 0; c < 3; ++c)
    index[c] = at(n) + int(corners[c].x()) * kStep[nextAxis(axis)] +
               int(corners[c].y()) * kStep[lastAxis(axis)];
  Vec2 inFace[2];
  Vec3 inBlade[2];
  int ends = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const int i = index[c], j = index[(c + 1) % 3];
    if (b.above(i) == b.above(j) || ends == 2) continue;
    const double share = planeShare(b, i, j);
    inFace[ends] = corners[c] + share * (corners[(c + 1) % 3] - corners[c]);
    inBlade[ends++] = inTriangle(
        t, b.place[std::size_t(i)] + share * (b.place[std::size_t(j)] - b.place[std::size_t(i)]));
  }
  if (ends < 2) return;
  double from = 0, to = 1;  // the part of the line within the blade
  for (int side = 0; side < 3; ++side) {
    const double a = inBlade[0][side] + kBladeReach, c = inBlade[1][side] + kBladeReach;
    if (a < 0 && c < 0) return;
    if (a < 0) from = std::max(from, a / (a - c));
    if (c < 0) to = std::min(to, a / (a - c));
  }
  const Vec2 line = inFace[1] - inFace[0];
  if (!(to > from) || line.norm() * (to - from) < kShortestTrace) return;
  severed.trace(b.first + n, axis,
                {(inFace[0] + from * line).cast<float>(), (inFace[0] + to * line).cast<float>()});
  b.crossed.push_back({n, axis, t.normal});
}

Aabb boundsOf(const BladeTriangle& t) {
  Aabb box;
  for (const Vec3& p : {t.corner, t.otherU, t.otherV}) box.grow(p);
  const Vec3 reach = 2 * kBladeReach * box.size() + Vec3::Constant(kOnPlane);
  return {box.min - reach, box.max + reach};
}

// A corner of the cell at the brick's node n.
int cornerOf(const Vec3i& n, int corner) {
  return at(n) + (corner & 1) + (corner >> 1 & 1) * kRasterSide +
         (corner >> 2) * kRasterSide * kRasterSide;
}

// A sweep's triangles are far smaller than a brick: most miss most of its cells. reach: bounds of
// the region in which the triangle can sever.
void severBrick(SeveredEdges& severed, GridBrick& b, const BladeTriangle& t, const Aabb& reach) {
  for (std::size_t i = 0; i < kPlacedNodes; ++i) b.height[i] = t.normal.dot(b.place[i] - t.corner);
  for (int cell = 0; cell < kBrickNodes * kBrickNodes * kBrickNodes; ++cell) {
    const Vec3i n(cell % kBrickNodes, cell / kBrickNodes % kBrickNodes,
                  cell / (kBrickNodes * kBrickNodes));
    if (!meets(b.cell(n), reach)) continue;
    int high = 0;  // of the cell's corners
    for (int c = 0; c < 8; ++c) high += b.above(cornerOf(n, c));
    if (high == 0 || high == 8) continue;
    for (int axis = 0; axis < 3; ++axis) {
      severEdge(severed, b, t, n, axis);
      traceHalf(severed, b, t, n, axis, {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1)});
      traceHalf(severed, b, t, n, axis, {Vec2(0, 0), Vec2(1, 1), Vec2(0, 1)});
    }
  }
}

// Continues shallow cuts in the faces that the blade crossed in a brick.
void deepenShallowCuts(SeveredEdges& severed, const ColourField& field, float iso,
                       const Vec3i& brick, CutsBetweenCells cuts,
                       std::span<const CrossedFace> crossed) {
  const BrickWindow window(field, severed, brick, iso);
  for (const CrossedFace& face : crossed) {
    const RingPoint below = belowShallowCut(window.grid, BrickWindow::index(face.node), face.axis);
    if (below.edge < 0) continue;
    const RingEdge edge = ringEdge(face.axis, below.edge);
    const Vec3i node = kBrickNodes * brick + face.node + edge.offset;
    if (mayBeSevered(severed, cuts, node, edge.axis))
      severed.sever(node, edge.axis, notTooThin(field, iso, node, edge.axis, below.share),
                    face.normal);
  }
}

}  // namespace

std::int64_t severAtRest(SeveredEdges& severed, const ColourField& field, float iso,
                         const SweptBlade& blade, CutsBetweenCells cuts) {
  if (blade.empty()) return 0;
  const std::int64_t before = severed.count();
  std::vector<Aabb> reach;
  for (const BladeTriangle& t : blade.triangles) reach.push_back(boundsOf(t));
  // A brick's edges and faces matter if its nodes, or those of a brick below, are not all empty.
  const auto matters = [&](const Vec3i& b) {
    for (int d = 0; d < 8; ++d) {
      const Vec3i n = b - Vec3i(d & 1, d >> 1 & 1, d >> 2 & 1);
      if ((n.array() >= 0).all() && field.slot(field.brickIndex(n)) != ColourField::kEmpty)
        return true;
    }
    return false;
  };
  // A blade on the border of two bricks severs edges of both.
  const IndexBox within = field.bricksIn(blade.bounds.padded(kBorder));
  GridBrick b;
  b.field = &field;
  b.iso = iso;
  b.cuts = cuts;
  std::vector<std::pair<Vec3i, std::vector<CrossedFace>>> crossed;
  for (std::int32_t k = 0; k < std::int32_t(within.count()); ++k) {
    const Vec3i brick = within.coordinates(k);
    if (!matters(brick)) continue;
    b.first = kBrickNodes * brick;
    for (int i = 0; i < kPlacedNodes; ++i) {
      const Vec3i node = b.first + Vec3i(i % kRasterSide, i / kRasterSide % kRasterSide,
                                         i / kRasterSide / kRasterSide);
      b.place[std::size_t(i)] = field.nodePosition(node.cast<double>());
    }
    for (std::size_t t = 0; t < blade.triangles.size(); ++t)
      if (meets(b.bounds(), reach[t])) severBrick(severed, b, blade.triangles[t], reach[t]);
    if (!b.crossed.empty()) crossed.emplace_back(brick, std::exchange(b.crossed, {}));
  }
  // Only now, since a brick's faces have edges of the next bricks too.
  for (const auto& [brick, faces] : crossed)
    deepenShallowCuts(severed, field, iso, brick, cuts, faces);
  return severed.count() - before;
}

}  // namespace resect
