// Inside tests: which points lie in a closed body, and which points a moving tool touches.
//
// Columns (lines along +z) are cast through the points themselves (collision/columns.h), not
// through the nodes of a grid. Meshes must be closed and oriented outwards. If shells (connected
// components) of a mesh overlap, the inside of the mesh is the union of their insides. A point on a
// face whose normal points to -z is outside; a point on a face whose normal points to +z is inside.
// So bodies that share a face share no point.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/pose.h"
#include "geometry/triangle_mesh.h"

namespace resect {

// One flag per point: 1 if the point is inside the mesh, decided exactly. Nothing is inside an
// empty mesh. Cost: a pass over the mesh and the points. Columns are cast only through the points
// that lie in the bounding box of the mesh.
std::vector<std::uint8_t> insideFlags(const TriangleMesh& mesh, std::span<const Vec3> points);

// One flag per world point: 1 if the rigid tool touches the point while the tool moves from pose
// `from` to pose `to`. The tool's position changes linearly. Its rotation changes along the shorter
// great circle. No point is skipped, however far the tool jumps and however thin it is.
//
// Points that are inside the tool at `from` or at `to` are always included. If the tool does not
// rotate, the answer is exact: in the tool's frame all points move along one direction, and columns
// are cast along this direction. If the tool rotates, the motion is divided into steps of at most 2
// degrees. In the tool's frame, the path of a point in a step is curved. The path may deviate from
// its chord by at most 1e-4 of the diagonal of the tool's bounding box; otherwise smaller steps are
// used. There are at most 4096 steps. In each step the chord replaces the path, and is tested
// against the tool's faces with exact integer edge functions. The cost grows with the number of
// points in the box round the whole motion.
std::vector<std::uint8_t> sweptInside(const TriangleMesh& toolInToolFrame, const Pose& from,
                                      const Pose& to, std::span<const Vec3> worldPoints);

}  // namespace resect
