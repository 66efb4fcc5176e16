// Scene nodes for models.
#pragma once

#include <vector>

#include "geometry/triangle_mesh.h"
#include "tools/tool.h"

class SoNode;
class SoSeparator;
class SoTransform;

namespace resect {

// A scene graph that draws the triangles. An edge looks sharp if the normals of its two triangles
// differ by more than `creaseDegrees`, otherwise smooth.
SoNode* makeModel(const TriangleMesh& mesh, double creaseDegrees = 30.0);

// A scene graph that draws the part with its finish. If the part is a jaw, the jaw is closed.
SoSeparator* makePart(const DrawnPart& part);

// An instrument as a scene graph, and the transforms that turn its jaws. The jaws are closed at
// first.
struct ToolNodes {
  struct Jaw {
    SoTransform* transform;
    Vec3f axis;
    float opens;  // rad: the angle about the axis when wide open
  };
  SoNode* model;
  std::vector<Jaw> jaws;
};

// Nodes for the tool's drawn parts, or for its mesh if it has no drawn parts. The tool's model file
// is not read. Throws Error if an index of a part is out of range, or if a part has normals, but
// not one per point.
ToolNodes makeToolNodes(const ToolModel& tool);

// An invisible box round a model, at least 2 cm along each axis. It makes thin models easy to
// click, and manipulators take their size from it. An empty model gets no box.
SoNode* makePickProxy(SoNode* model);

}  // namespace resect
