// Winding numbers of points: counts where a ray along +X from each point crosses a closed mesh.
#pragma once

#include <span>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace resect {

// For each point: how often a ray along +X leaves the mesh, less how often it enters. The mesh must
// be closed and oriented. The number is 1 inside a body, 0 outside, -1 inside a body that is inside
// out. A ray through an edge or a corner counts once, since edges are half-open and both triangles
// at an edge evaluate it alike. A point on the surface gets the number of one of the two sides.
// Triangles are sorted into slabs along Z, so m points cost about m * sqrt(triangles), after
// O(triangles) for the sorting.
std::vector<int> crossingNumbers(const TriangleMesh& mesh, std::span<const Vec3> points);

}  // namespace resect
