// Exact inside tests: which points lie in a closed body, and which a moving tool touches.
//
// Columns are cast through the points themselves (collision/columns.h); there are no pixels. Meshes
// are closed and oriented outwards; overlapping shells count as their union. Half-open at the
// surface: a point on a lower face is outside, on an upper face inside (along z), so bodies that
// share a face share no point.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/pose.h"
#include "geometry/triangle_mesh.h"

namespace resect {

// One flag per point: 1 inside. An empty mesh holds nothing. Cost: a pass over mesh and points;
// only points in the mesh's box are cast.
std::vector<std::uint8_t> insideFlags(const TriangleMesh& mesh, std::span<const Vec3> points);

// One flag per world point: 1 if the rigid tool, moving from pose `from` to pose `to` (position
// linearly, rotation along the shorter great circle), touches it on the way. No point is skipped,
// however far the tool jumps and however thin it is.
//
// Includes the points inside at either pose. Without rotation the answer is exact: in the tool's
// frame all points move along one direction, and columns are cast along it. With rotation the
// motion is cut into steps of at most 2 degrees (finer if a path would leave its chord by more than
// 1e-4 of the tool's diagonal); in each step a point's path in the tool's frame is taken as its
// chord and tested against the tool's faces with exact integer edge functions. Cost follows the
// points inside the box of the motion.
std::vector<std::uint8_t> sweptInside(const TriangleMesh& toolInToolFrame, const Pose& from,
                                      const Pose& to, std::span<const Vec3> worldPoints);

}  // namespace resect
