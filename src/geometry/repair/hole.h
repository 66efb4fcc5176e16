// The holes of a surface as closed loops, and triangles that fill them.
#pragma once

#include <span>

#include "geometry/triangle_mesh.h"

namespace resect {

// In a closed mesh every edge is used equally often in both directions. Returns the directed edges
// that the mesh lacks for this, as closed loops. Each loop has at least three points and no point
// twice. A triangulation of every loop, in its direction, closes the mesh. The missing edges always
// form loops, since a boundary has no ends. Deterministic, O(n log n).
std::vector<std::vector<std::int32_t>> holeLoops(const TriangleMesh& mesh);

// Appends loop.size() - 2 triangles that span the loop, by the method of closeHoles() in repair.h.
void fillHole(std::span<const Vec3> points, std::span<const std::int32_t> loop,
              std::vector<Triangle>& triangles);

}  // namespace resect
