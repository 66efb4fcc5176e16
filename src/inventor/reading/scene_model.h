// Extracts the surfaces of a scene graph.
#pragma once

#include <string>

#include "io/model.h"

class SoNode;

namespace resect {

// Which code converts shapes to triangles. Converted: Resect's own converters, which check all
// indices and counts; Coin (the Inventor library) converts the kinds of shape for which Resect has
// no converter. ByCoin: Coin converts all shapes. ByCoin is a reference for tests, and is safe for
// valid scenes only.
enum class ShapeReading { Converted, ByCoin };

// Adds to model.parts the triangles of all shapes that would be drawn. Switch, LevelOfDetail, USE,
// Array and Units nodes are applied, and so are all transforms. Lines, points, flat text and
// draggers are left out. The triangles of a shape go to the part that has the shape's DEF name. If
// the shape has no DEF name, the DEF name of the innermost enclosing node that has one is used. A
// part gets the material of its first shape. If a shape is a TriangleStripSet with one normal per
// point, the part gets these normals, too. If the scene was saved by Resect, model.places gets the
// poses of the scene's tools and camera (inventor/reading/scene_places.h). Throws an Error about
// model.path if a count or an index in the scene is out of range, or if the scene has more than 20
// million triangles. The caller must hold a reference to `root` (SoNode::ref()).
void addScene(SoNode* root, ShapeReading reading, Model& model);

}  // namespace resect
