// Makes scene nodes for models.
#pragma once

#include <vector>

#include "geometry/triangle_mesh.h"
#include "tools/tool.h"

class SoNode;
class SoSeparator;
class SoTransform;

namespace resect {

// A scene graph that draws a mesh. An edge looks sharp if the normals of its two triangles differ
// by more than `creaseDegrees`. All other edges look smooth.
SoNode* makeModel(const TriangleMesh& mesh, double creaseDegrees = 30.0);

// A scene graph that draws a part of a tool with the part's finish (its colour and gloss). A jaw is
// drawn closed.
SoSeparator* makePart(const DrawnPart& part);

// A tool as a scene graph, and the transforms that turn the tool's jaws. At first the jaws are
// closed.
struct ToolNodes {
  struct Jaw {
    SoTransform* transform;
    Vec3f axis;
    float opens;  // angle about `axis` from the closed to the wide open jaw, rad
  };
  SoNode* model;
  std::vector<Jaw> jaws;
};

// Makes nodes from the tool's drawn parts. If the tool has no drawn parts, makes nodes from the
// tool's mesh. No file is read. Throws Error if an index in a mesh is out of range. Also throws
// Error if a part has normals, but their number is not the number of points.
ToolNodes makeToolNodes(const ToolModel& tool);

// An invisible box round a model. The box is at least 2 cm long along each axis. It makes thin
// models easy to click, and manipulators take their size from it. If the model is empty, there is
// no box.
SoNode* makePickProxy(SoNode* model);

}  // namespace resect
