// The holes of a surface as closed loops, and triangles that fill them.
#pragma once

#include <span>

#include "geometry/triangle_mesh.h"

namespace resect {

// Finds the holes of a mesh as closed loops. In a closed and oriented mesh, triangles use every
// edge equally often in both directions. For an edge that `mesh` uses more often in one direction,
// directed edges in the opposite direction are missing. The loops consist of these missing edges.
// The loops are always closed, since at each point as many missing edges begin as end. Each loop is
// returned as the indices of its points. A loop has at least three points and contains no point
// twice. If every loop is filled with triangles that have the loop's orientation, the mesh is
// closed. The result is deterministic. Cost: O(n log n) for n triangles.
std::vector<std::vector<std::int32_t>> holeLoops(const TriangleMesh& mesh);

// Fills a loop: appends loop.size() - 2 triangles to `triangles`. The method is the one that
// closeHoles() in geometry/repair/repair.h describes.
void fillHole(std::span<const Vec3> points, std::span<const std::int32_t> loop,
              std::vector<Triangle>& triangles);

}  // namespace resect
