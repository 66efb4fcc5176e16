// How does a model become nodes of a scene?
#pragma once

#include "geometry/triangle_mesh.h"

class SoNode;

namespace resect {

// A model from triangles, with a crease where faces meet at more than `creaseDegrees`.
SoNode* makeModel(const TriangleMesh& mesh, double creaseDegrees = 30.0);

// An unseen box round a model, at least a finger wide: what a pointer hits, and what a manipulator
// is sized by.
SoNode* makePickProxy(SoNode* model);

}  // namespace resect
