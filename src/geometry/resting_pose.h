// The pose in which a rigid body comes to rest on a table.
#pragma once

#include "geometry/triangle_mesh.h"

namespace resect {

// Turns the body from its present orientation to a near one in which it rests on a horizontal table
// (Y up): there the height of its centre of mass, at uniform density, is a local minimum. Found by
// descent on this height, to about 0.1 degrees. Identity for a mesh that encloses nothing.
Eigen::Quaterniond restingRotation(const TriangleMesh& mesh);

// The pose with this rotation in which the mesh stands on the table: the bottom of its bounding box
// is at y = 0 and centred on the origin.
Pose standOnTable(const TriangleMesh& mesh, const Eigen::Quaterniond& rotation);

}  // namespace resect
