// The surface that a cutting edge sweeps between two poses, and the point where a straight segment
// crosses this surface.
//
// The edge is a poly-line in the tool's frame. It sweeps a strip of triangles. Where two triangles
// share a side, they have exactly the same corners. A motion with rotation is divided into steps,
// so that the strip stays within `flatness` of the edge's true path.
//
// No segment slips through between two triangles, since each triangle extends beyond its sides by
// kBladeReach of its size. "Above the strip" means the side to which the normals point. If an end
// of a segment lies on the strip (within rounding error of a triangle's plane), this end counts as
// above the strip. So if two segments come from opposite sides and end at the same point of the
// strip, only the segment from below crosses the strip.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/aabb.h"
#include "geometry/pose.h"

namespace resect {

// How far a triangle of the strip extends beyond its sides, in barycentric coordinates.
inline constexpr double kBladeReach = 1e-4;

// A triangle of the strip. A point p of its plane has the coordinates u = alongU . (p - corner) and
// v = alongV . (p - corner). The point lies in the triangle if u >= 0, v >= 0 and u + v <= 1.
struct BladeTriangle {
  Vec3 corner;  // world, m
  Vec3 normal;  // unit; points to the same side of the strip in all triangles
  Vec3 alongU;  // 1/m
  Vec3 alongV;  // 1/m
  Vec3 otherU;  // corner where u = 1, m
  Vec3 otherV;  // corner where v = 1, m
};

struct SweptBlade {
  std::vector<BladeTriangle> triangles;  // none if the edge stands still or slides along itself
  Aabb bounds;                           // of all triangles, world, m

  bool empty() const { return triangles.empty(); }
};

// `edge`: points in the tool's frame, m; fewer than two points sweep nothing. `flatness` > 0, m:
// largest distance between the path of a point of the edge in one step of the motion and the chord
// of this path. The pose is interpolated as in geometry/pose.h: the position linearly, the rotation
// along the shorter great circle.
SweptBlade sweepBlade(std::span<const Vec3> edge, const Pose& from, const Pose& to,
                      double flatness = 1e-4);

// The strip between two positions of an edge. `before` and `after`: the edge's points in the world,
// m. Both must have the same number of points.
SweptBlade ruledBlade(std::span<const Vec3> before, std::span<const Vec3> after);

// Appends the triangles of the sweep `more` to `blade`.
void append(SweptBlade& blade, const SweptBlade& more);

// A crossing of the strip by a segment from p to q.
struct BladeCrossing {
  double share = 0;           // fraction of the way from p to q, in [0, 1]
  std::int32_t triangle = 0;  // index in SweptBlade::triangles
};

// The crossing nearest to p; no value if the segment from p to q does not cross the strip. Cost:
// two scalar products per triangle.
std::optional<BladeCrossing> crossing(const SweptBlade& blade, const Vec3& p, const Vec3& q);

}  // namespace resect
