// The pose in which a rigid body comes to rest on a table.
#pragma once

#include "geometry/triangle_mesh.h"

namespace resect {

// The rotation that brings the body from its present orientation to one in which it can rest on a
// horizontal table (Y is up). In that orientation the height of the centre of mass has a local
// minimum. The density of the body is taken as uniform. A descent from the present orientation
// finds the minimum, with an error of about 0.1 degrees. If the mesh encloses no volume, the result
// is the identity.
Eigen::Quaterniond restingRotation(const TriangleMesh& mesh);

// A pose in which the mesh stands on the table. `rotation` is the rotation of the pose. The middle
// of the bottom face of the mesh's bounding box is at the origin.
Pose standOnTable(const TriangleMesh& mesh, const Eigen::Quaterniond& rotation);

}  // namespace resect
