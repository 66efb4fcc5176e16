// The holes of a surface as closed loops, and triangles that fill them.
#pragma once

#include <span>

#include "geometry/triangle_mesh.h"

namespace resect {

// The edges that are missing for every edge of the mesh to be used equally often in both
// directions, as closed loops of at least three points, each point once per loop; a triangulation
// of every loop, in its direction, closes the mesh. They always form loops, since a boundary has no
// ends. Deterministic, O(n log n).
std::vector<std::vector<std::int32_t>> holeLoops(const TriangleMesh& mesh);

// Appends loop.size() - 2 triangles that span the loop; see repair.h.
void fillHole(std::span<const Vec3> points, std::span<const std::int32_t> loop,
              std::vector<Triangle>& triangles);

}  // namespace resect
