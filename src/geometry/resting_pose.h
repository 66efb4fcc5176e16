// The pose in which a rigid body comes to rest on a table.
#pragma once

#include "geometry/triangle_mesh.h"

namespace resect {

// The rotation that turns the body from its present orientation to a nearby one in which it can
// rest on a horizontal table (Y up): one in which the height of the centre of mass, at uniform
// density, is a local minimum. The minimum is found by descent, to about 0.1 degrees. The result is
// the identity for a mesh that encloses no volume.
Eigen::Quaterniond restingRotation(const TriangleMesh& mesh);

// The pose with this rotation in which the mesh stands on the table. The bottom of the bounding box
// is then at y = 0 and centred on the origin.
Pose standOnTable(const TriangleMesh& mesh, const Eigen::Quaterniond& rotation);

}  // namespace resect
