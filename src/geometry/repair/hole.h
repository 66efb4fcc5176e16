// The holes of a surface as closed loops, and triangles that fill them.
#pragma once

#include <span>

#include "geometry/triangle_mesh.h"

namespace resect {

// In a closed mesh every edge is used equally often in both directions. This function returns the
// directed edges that must be added to `mesh` so that this holds for all its edges. They are joined
// to closed loops; this is always possible, since a boundary has no ends. Each loop has at least
// three points and no point twice. The mesh becomes closed if every loop is filled with triangles
// that have the orientation of the loop. Deterministic, O(n log n).
std::vector<std::vector<std::int32_t>> holeLoops(const TriangleMesh& mesh);

// Appends loop.size() - 2 triangles that fill the loop, by the method of closeHoles() in repair.h.
void fillHole(std::span<const Vec3> points, std::span<const std::int32_t> loop,
              std::vector<Triangle>& triangles);

}  // namespace resect
