#include "wound/blade_raster.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "wound/cut_grid.h"

namespace resect {
namespace {

constexpr double kOnPlane = 1e-12;       // m, as in collision/swept_blade.cpp
constexpr double kShortestTrace = 1e-6;  // node spacings
constexpr int kSide = 5;
constexpr int kStep[3] = {1, kSide, kSide* kSide};
using Vec2 = Eigen::Vector2d;

int at(const Vec3i& n) { return (n.z() * kSide + n.y()) * kSide + n.x(); }

// The nodes of a brick: positions, and heights above one of the blade's triangles.
struct PlacedBrick {
  Vec3i first;
  std::array<Vec3, kPlacedNodes> place;
  std::array<double, kPlacedNodes> height;
  std::array<Aabb, kBrickNodes * kBrickNodes * kBrickNodes> cells;  // bounds, x fastest
  Aabb bounds;
  CutsBetweenCells cuts;

  bool above(int i) const { return height[std::size_t(i)] >= -kOnPlane; }
  bool known(int i) const { return !std::isnan(height[std::size_t(i)]); }
};

// Fraction of the way from i to j at which the triangle's plane is met.
double planeShare(const PlacedBrick& b, int i, int j) {
  const double from = b.height[std::size_t(i)], to = b.height[std::size_t(j)];
  return std::clamp(from / (from - to), 0.0, 1.0);
}

// Barycentric coordinates, each >= 0 inside.
Vec3 inTriangle(const BladeTriangle& t, const Vec3& p) {
  const double u = t.alongU.dot(p - t.corner), v = t.alongV.dot(p - t.corner);
  return {u, v, 1 - u - v};
}

// Gradient of the height along the grid's axes: the blade's normal in rest space.
Vec3 restNormal(const PlacedBrick& b, const Vec3i& n, int axis) {
  const int i = at(n), j = i + kStep[axis];
  Vec3 normal;
  normal[axis] = b.height[std::size_t(j)] - b.height[std::size_t(i)];
  for (const int other : {nextAxis(axis), lastAxis(axis)}) {
    const int step = n[other] + 1 < kSide ? kStep[other] : -kStep[other];
    const double slope = 0.5 * (b.height[std::size_t(i + step)] - b.height[std::size_t(i)] +
                                b.height[std::size_t(j + step)] - b.height[std::size_t(j)]);
    normal[other] = std::isnan(slope) ? 0 : step > 0 ? slope : -slope;
  }
  return normal;
}

void severEdge(SeveredEdges& severed, const PlacedBrick& b, const BladeTriangle& t, const Vec3i& n,
               int axis) {
  const int i = at(n), j = i + kStep[axis];
  if (!b.known(i) || !b.known(j) || b.above(i) == b.above(j)) return;
  if (b.cuts == CutsBetweenCells::One && severed.betweenCells(b.first + n, axis)) return;
  const double share = planeShare(b, i, j);
  const Vec3 p =
      b.place[std::size_t(i)] + share * (b.place[std::size_t(j)] - b.place[std::size_t(i)]);
  if (inTriangle(t, p).minCoeff() < -kBladeReach) return;
  severed.sever(b.first + n, axis, share, restNormal(b, n, axis));
}

// Half of a face stays a triangle in the world, so its intersection with the blade is straight in
// the world and at rest.
void traceHalf(SeveredEdges& severed, const PlacedBrick& b, const BladeTriangle& t, const Vec3i& n,
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
    if (!b.known(i)) return;
    if (b.above(i) == b.above(j) || !b.known(j) || ends == 2) continue;
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
}

Aabb boundsOf(const BladeTriangle& t) {
  Aabb box;
  for (const Vec3& p : {t.corner, t.otherU, t.otherV}) box.grow(p);
  const Vec3 reach = 2 * kBladeReach * box.size() + Vec3::Constant(kOnPlane);
  return {box.min - reach, box.max + reach};
}

// A corner of the cell at the brick's node n.
int cornerOf(const Vec3i& n, int corner) {
  return at(n) + (corner & 1) + (corner >> 1 & 1) * kSide + (corner >> 2) * kSide * kSide;
}

// visit(cell's number, its first node)
template <typename Visit>
void visitCells(Visit visit) {
  for (int z = 0, cell = 0; z < kBrickNodes; ++z)
    for (int y = 0; y < kBrickNodes; ++y)
      for (int x = 0; x < kBrickNodes; ++x) visit(std::size_t(cell++), Vec3i(x, y, z));
}

// Bounds of the cells, merged from neighbouring nodes along x, then y, then z. Nodes without a
// position are left out.
void findBounds(PlacedBrick& b) {
  std::array<Aabb, kPlacedNodes> box;
  for (std::size_t i = 0; i < kPlacedNodes; ++i) {
    box[i] = {};
    if (!std::isnan(b.place[i].x())) box[i].grow(b.place[i]);
  }
  for (const int step : kStep)
    for (std::size_t i = 0; i + std::size_t(step) < kPlacedNodes; ++i)
      box[i].grow(box[i + std::size_t(step)]);
  b.bounds = {};
  visitCells([&](std::size_t cell, const Vec3i& n) {
    b.cells[cell] = box[std::size_t(at(n))];
    b.bounds.grow(b.cells[cell]);
  });
}

// A sweep's triangles are far smaller than a brick: most miss most of its cells. reach: bounds of
// the region in which the triangle can sever.
void severBrick(SeveredEdges& severed, PlacedBrick& b, const BladeTriangle& t, const Aabb& reach) {
  bool heightsKnown = false;
  visitCells([&](std::size_t cell, const Vec3i& n) {
    if (!meets(b.cells[cell], reach)) return;
    if (!heightsKnown)
      for (std::size_t i = 0; i < kPlacedNodes; ++i)
        b.height[i] = t.normal.dot(b.place[i] - t.corner);
    heightsKnown = true;
    int high = 0;  // of the cell's corners
    for (int c = 0; c < 8; ++c) high += b.above(cornerOf(n, c));
    if (high == 0 || high == 8) return;
    for (int axis = 0; axis < 3; ++axis) {
      severEdge(severed, b, t, n, axis);
      traceHalf(severed, b, t, n, axis, {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1)});
      traceHalf(severed, b, t, n, axis, {Vec2(0, 0), Vec2(1, 1), Vec2(0, 1)});
    }
  });
}

}  // namespace

std::int64_t severAlong(SeveredEdges& severed, const ColourField& field, const SweptBlade& blade,
                        std::span<const std::int64_t> bricks, const PlaceNodes& place,
                        CutsBetweenCells cuts) {
  const std::int64_t before = severed.count();
  std::vector<Aabb> reach;
  for (const BladeTriangle& t : blade.triangles) reach.push_back(boundsOf(t));
  PlacedBrick b;
  b.cuts = cuts;
  for (const std::int64_t index : bricks) {
    const Vec3i brick = field.brick(index);
    b.first = kBrickNodes * brick;
    place(brick, b.place);
    findBounds(b);
    for (std::size_t t = 0; t < blade.triangles.size(); ++t)
      if (meets(b.bounds, reach[t])) severBrick(severed, b, blade.triangles[t], reach[t]);
  }
  return severed.count() - before;
}

std::int64_t severAtRest(SeveredEdges& severed, const ColourField& field, const SweptBlade& blade) {
  if (blade.empty()) return 0;
  const IndexBox within = field.bricksIn(blade.bounds);
  // A brick's edges and faces matter if its nodes, or those of a brick below, are not all empty.
  const auto matters = [&](const Vec3i& b) {
    for (int d = 0; d < 8; ++d) {
      const Vec3i n = b - Vec3i(d & 1, d >> 1 & 1, d >> 2 & 1);
      if ((n.array() >= 0).all() && field.slot(field.brickIndex(n)) != ColourField::kEmpty)
        return true;
    }
    return false;
  };
  std::vector<std::int64_t> bricks;
  for (std::int32_t i = 0; i < std::int32_t(within.count()); ++i)
    if (matters(within.coordinates(i))) bricks.push_back(field.brickIndex(within.coordinates(i)));
  return severAlong(severed, field, blade, bricks,
                    [&](const Vec3i& brick, std::span<Vec3, kPlacedNodes> places) {
                      const Vec3 first = (kBrickNodes * brick).cast<double>();
                      for (int i = 0; i < kPlacedNodes; ++i) {
                        const Vec3i at(i % kSide, i / kSide % kSide, i / kSide / kSide);
                        places[std::size_t(i)] = field.nodePosition(first + at.cast<double>());
                      }
                    });
}

}  // namespace resect
