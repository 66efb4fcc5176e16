// The surface that a cutting edge sweeps between two poses, and the segments that cross it.
//
// The edge, a poly-line in the tool's frame, sweeps a strip of triangles that share their corners
// exactly; a motion with rotation is cut into steps so that the strip stays within `flatness` of
// the edge's true path. No segment passes through a seam: each triangle extends beyond its sides by
// kBladeReach of its size. Where two segments on opposite sides of the strip meet in a point of it,
// only one crosses: a point within rounding error of a triangle's plane counts as above the plane
// (on the normal's side), so only a segment from below crosses.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/aabb.h"
#include "geometry/pose.h"

namespace resect {

// How far a triangle of the strip extends beyond its sides, in barycentric coordinates.
inline constexpr double kBladeReach = 1e-4;

// A point p of its plane has u = alongU . (p - corner) and v = alongV . (p - corner). The point
// lies in the triangle if u >= 0, v >= 0 and u + v <= 1.
struct BladeTriangle {
  Vec3 corner;  // world, m
  Vec3 normal;  // unit; on the same side all along the strip
  Vec3 alongU;  // 1/m
  Vec3 alongV;  // 1/m
  Vec3 otherU;  // corner where u = 1, m
  Vec3 otherV;  // corner where v = 1, m
};

struct SweptBlade {
  std::vector<BladeTriangle> triangles;  // none if the edge stands still or moves only along itself
  Aabb bounds;                           // of all triangles, m

  bool empty() const { return triangles.empty(); }
};

// `edge`: points in the tool's frame, m; fewer than two points sweep nothing. `flatness` > 0, m:
// how far a chord may stray from the arc of a turning edge. The pose is interpolated as in
// geometry/pose.h: position linearly, rotation along the shorter great circle.
SweptBlade sweepBlade(std::span<const Vec3> edge, const Pose& from, const Pose& to,
                      double flatness = 1e-4);

// The strip between two positions of an edge, `before` and `after`, which must have the same number
// of points.
SweptBlade ruledBlade(std::span<const Vec3> before, std::span<const Vec3> after);

struct BladeCrossing {
  double share = 0;           // of the way from p to q, in [0, 1]
  std::int32_t triangle = 0;  // in SweptBlade::triangles
};

// Of the points where the segment from p to q crosses the strip, the one nearest to p. Cost: two
// scalar products per triangle.
std::optional<BladeCrossing> crossing(const SweptBlade& blade, const Vec3& p, const Vec3& q);

}  // namespace resect
