// Scene nodes for models.
#pragma once

#include "geometry/triangle_mesh.h"

class SoNode;

namespace resect {

// A model from triangles, with creases where faces meet at more than `creaseDegrees`.
SoNode* makeModel(const TriangleMesh& mesh, double creaseDegrees = 30.0);

// An invisible box round a model, at least a finger wide, for picking and for the size of
// manipulators.
SoNode* makePickProxy(SoNode* model);

}  // namespace resect
