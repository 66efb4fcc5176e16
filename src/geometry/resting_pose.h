// The pose in which a rigid body comes to rest on a table.
#pragma once

#include "geometry/triangle_mesh.h"

namespace resect {

// The rotation from the body's present orientation to the nearest in which it rests on a horizontal
// table (Y up): its centre of mass, at uniform density, at a local minimum of height. Identity for
// a mesh that encloses nothing. Found by descent on the height of the centre over the supporting
// plane, to about 0.1 degrees.
Eigen::Quaterniond restingRotation(const TriangleMesh& mesh);

// The pose with this rotation in which the mesh stands on the table: the lowest side of its box at
// y = 0, centred over the origin.
Pose standOnTable(const TriangleMesh& mesh, const Eigen::Quaterniond& rotation);

}  // namespace resect
