// How does a rigid body lie on a table when it is put down?
#pragma once

#include "geometry/triangle_mesh.h"

namespace resect {

// The rotation that takes the body, held as it is, to the nearest pose in which it lies still on a
// horizontal table (Y up): its centre of mass, of even density, as low as it gets by rolling. Turns
// by the shortest way; identity for a mesh that encloses nothing. Found by descent on the height of
// the centre over the supporting plane, to about 0.1 degrees.
Eigen::Quaterniond restingRotation(const TriangleMesh& mesh);

// The pose that turns the mesh so and stands it on the table: its box's lowest side at y = 0,
// centred over the origin.
Pose standOnTable(const TriangleMesh& mesh, const Eigen::Quaterniond& rotation);

}  // namespace resect
