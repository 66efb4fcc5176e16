// Vessels as meshes of tubes, to be drawn.
#pragma once

#include "anatomy/anatomy.h"
#include "geometry/triangle_mesh.h"

namespace resect {

// A closed prism with eight sides round each segment of the kind; prisms overlap where segments
// meet.
TriangleMesh vesselMesh(const Anatomy& anatomy, VesselKind kind);

}  // namespace resect
