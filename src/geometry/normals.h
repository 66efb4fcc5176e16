// Vertex normals of a smooth surface.
#pragma once

#include <vector>

#include "geometry/triangle_mesh.h"

namespace resect {

// The unit normal of every point. To compute it, the normals of the point's triangles are added,
// each weighted by the triangle's angle at the point, and the sum is normalised. So the normal does
// not depend on how a flat part of the surface is divided into triangles (Thuermer and Wuethrich
// 1998). A point gets the normal +Y if it has no triangle of positive area. Cost: O(n) for n
// triangles and points.
std::vector<Vec3> pointNormals(const TriangleMesh& mesh);

}  // namespace resect
