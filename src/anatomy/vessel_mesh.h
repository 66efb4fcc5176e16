// Vessels as meshes of tubes, to be drawn.
#pragma once

#include "anatomy/anatomy.h"
#include "geometry/triangle_mesh.h"

namespace resect {

// Makes a closed prism with eight sides round each vessel segment of the kind. Prisms overlap where
// segments meet.
TriangleMesh vesselMesh(const Anatomy& anatomy, VesselKind kind);

}  // namespace resect
