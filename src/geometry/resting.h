// How does a rigid body come to lie on a table?
#pragma once

#include "geometry/triangle_mesh.h"

namespace resect {

// The rotation, about the volume centroid, in which the body's centre of mass lies lowest over a
// flat table (top +Y up): its most stable rest. Of all such rotations the shortest. Searched over
// 2 000 directions and refined to 0.1 degrees: O(points), about 20 ms for 10 000 points. The empty
// mesh stays as it is.
Eigen::Quaterniond restingRotation(const TriangleMesh& mesh);

// The pose that turns the mesh so and stands its box centred on the table top y = 0.
Pose standOnTable(const TriangleMesh& mesh, const Eigen::Quaterniond& rotation);

}  // namespace resect
