// Vertex normals of a smooth surface.
#pragma once

#include <vector>

#include "geometry/triangle_mesh.h"

namespace resect {

// Unit normal of every point: the mean of its triangles' normals, each weighted by the triangle's
// angle at the point. So the normals do not depend on how a flat part is divided into triangles
// (Thuermer and Wuethrich 1998). A point without triangles of positive area gets +Y. O(n).
std::vector<Vec3> pointNormals(const TriangleMesh& mesh);

}  // namespace resect
