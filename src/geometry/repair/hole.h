// The holes of a surface as closed loops, and triangles that fill them.
#pragma once

#include <span>

#include "geometry/triangle_mesh.h"

namespace resect {

// In a closed mesh, triangles use every edge equally often in both directions. This function finds
// the directed edges that must be added to `mesh` so that this is true of all its edges. It joins
// these edges to closed loops, which is always possible, since a boundary has no ends. It returns
// each loop as the indices of its points. Each loop has at least three points and contains no point
// twice. If every loop is filled with triangles that have the loop's orientation, the mesh is
// closed. The result is deterministic. Cost: O(n log n) for n triangles.
std::vector<std::vector<std::int32_t>> holeLoops(const TriangleMesh& mesh);

// Fills a loop: appends loop.size() - 2 triangles to `triangles`. The method is the one that
// closeHoles() in geometry/repair/repair.h describes.
void fillHole(std::span<const Vec3> points, std::span<const std::int32_t> loop,
              std::vector<Triangle>& triangles);

}  // namespace resect
