// The surface that a cutting edge sweeps between two poses, and the segments that cross it.
//
// The edge, a poly-line in the tool's frame, sweeps a strip of triangles that share their corners
// exactly; a motion that turns is cut into steps so that the strip stays within `flatness` of the
// edge's true path. Seams are closed: each triangle extends beyond its sides by kBladeReach of its
// size. A point that lies in the strip is not crossed twice: a point within rounding of a
// triangle's plane counts as above it, so of the segments that end there only those from below
// cross.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/aabb.h"
#include "geometry/pose.h"

namespace resect {

// How far a triangle of the strip extends beyond its sides, in barycentric coordinates.
inline constexpr double kBladeReach = 1e-4;

struct BladeTriangle {
  Vec3 corner;  // world, m
  Vec3 normal;  // unit; on the same side all along the strip
  Vec3 alongU;  // dual to the sides at the corner: u = alongU . (p - corner), inside: u >= 0,
  Vec3 alongV;  // v = alongV . (p - corner) >= 0, u + v <= 1
  Vec3 otherU;  // the corners u = 1 and v = 1, m
  Vec3 otherV;
};

struct SweptBlade {
  std::vector<BladeTriangle> triangles;  // none when the edge does not move, or along itself alone
  Aabb bounds;                           // of all triangles, m

  bool empty() const { return triangles.empty(); }
};

// `edge`: points in the tool's frame, m; fewer than two sweep nothing. `flatness` > 0, m: how far
// a chord may stray from the arc of a turning edge. Position moves linearly, rotation along the
// shorter great circle, as geometry/pose.h interpolates.
SweptBlade sweepBlade(std::span<const Vec3> edge, const Pose& from, const Pose& to,
                      double flatness = 1e-4);

// The strip between an edge before and after, point by point; both have the same number of points.
SweptBlade ruledBlade(std::span<const Vec3> before, std::span<const Vec3> after);

struct BladeCrossing {
  double share = 0;           // of the way from p to q, in [0, 1]
  std::int32_t triangle = 0;  // in SweptBlade::triangles
};

// The crossing nearest to p, if the segment from p to q is crossed. Cost: two products per
// triangle.
std::optional<BladeCrossing> crossing(const SweptBlade& blade, const Vec3& p, const Vec3& q);

}  // namespace resect
