// Vertex normals of a smooth surface.
#pragma once

#include <vector>

#include "geometry/triangle_mesh.h"

namespace resect {

// Unit normal of every point: the mean over its triangles weighted by corner angle, which does not
// depend on how a flat part is cut into triangles (Thuermer and Wuethrich 1998). A point without
// area gets +Y. O(n).
std::vector<Vec3> pointNormals(const TriangleMesh& mesh);

}  // namespace resect
