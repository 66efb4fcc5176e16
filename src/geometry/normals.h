// Vertex normals of a smooth surface.
#pragma once

#include <vector>

#include "geometry/triangle_mesh.h"

namespace resect {

// The unit normal of every point. It is the normalised mean of the normals of the point's
// triangles, each weighted by the triangle's angle at the point. So it does not depend on how a
// flat part is divided into triangles (Thuermer and Wuethrich 1998). A point without triangles of
// positive area gets +Y. O(n).
std::vector<Vec3> pointNormals(const TriangleMesh& mesh);

}  // namespace resect
