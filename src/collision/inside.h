// Exact inside tests: which points lie in a closed body, and which a moving tool touches.
//
// Columns are cast through the points themselves (collision/columns.h); there are no pixels. Meshes
// must be closed and oriented outwards; overlapping shells count as their union. Along z a point on
// a lower face is outside and a point on an upper face is inside, so bodies that share a face share
// no point.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/pose.h"
#include "geometry/triangle_mesh.h"

namespace resect {

// One flag per point: 1 inside. Nothing is inside an empty mesh. Cost: a pass over mesh and points;
// columns are cast only through points in the mesh's box.
std::vector<std::uint8_t> insideFlags(const TriangleMesh& mesh, std::span<const Vec3> points);

// One flag per world point: 1 if the rigid tool touches the point while it moves from pose `from`
// to pose `to` (its position linearly, its rotation along the shorter great circle). No point is
// skipped, however far the tool jumps and however thin it is.
//
// The points inside at either pose are included. Without rotation the answer is exact: in the
// tool's frame all points move along one direction, and columns are cast along it. With rotation
// the motion is cut into steps of at most 2 degrees (finer if a path would leave its chord by more
// than 1e-4 of the tool's diagonal); in each step the path of a point in the tool's frame is
// replaced by its chord, which is tested against the tool's faces with exact integer edge
// functions. The cost grows with the number of points inside the box of the motion.
std::vector<std::uint8_t> sweptInside(const TriangleMesh& toolInToolFrame, const Pose& from,
                                      const Pose& to, std::span<const Vec3> worldPoints);

}  // namespace resect
