// Computes winding numbers of points. From each point a ray is cast along +X, and the ray's
// crossings with a closed mesh are counted.
#pragma once

#include <span>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace resect {

// For each point: the number of times that its ray leaves the mesh, minus the number of times that
// its ray enters the mesh. The mesh must be closed and oriented. The result is 1 inside a body, 0
// outside, and -1 inside a body whose normals point inwards. If a ray crosses the mesh at an edge
// or a corner, the crossing is counted once. A point on the surface gets the number of one of the
// two sides. Cost for n triangles: O(n) to sort the triangles into slabs along Z, and then about
// sqrt(n) for each point.
std::vector<int> crossingNumbers(const TriangleMesh& mesh, std::span<const Vec3> points);

}  // namespace resect
