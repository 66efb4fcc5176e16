// Winding numbers of points. For each point a ray along +X is cast, and its crossings with a closed
// mesh are counted.
#pragma once

#include <span>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace resect {

// For each point: the number of times that the ray leaves the mesh, minus the number of times that
// it enters. The mesh must be closed and oriented. The result is 1 inside a body, 0 outside, and -1
// inside a body whose normals point inwards. A crossing at an edge or a corner counts once, since
// edges are half-open and the two triangles at an edge evaluate that edge alike. A point on the
// surface gets the number of one of the two sides. Cost: O(triangles) to sort the triangles into
// slabs along Z, then about sqrt(triangles) per point.
std::vector<int> crossingNumbers(const TriangleMesh& mesh, std::span<const Vec3> points);

}  // namespace resect
