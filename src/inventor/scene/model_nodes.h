// Scene nodes for models.
#pragma once

#include "geometry/triangle_mesh.h"

class SoNode;

namespace resect {

// A scene graph that draws the triangles. An edge looks sharp if the normals of its two triangles
// differ by more than `creaseDegrees`, else smooth.
SoNode* makeModel(const TriangleMesh& mesh, double creaseDegrees = 30.0);

// An invisible box round a model, at least 2 cm along each axis. It makes thin models easy to
// click, and manipulators take their size from it. An empty model gets no box.
SoNode* makePickProxy(SoNode* model);

}  // namespace resect
