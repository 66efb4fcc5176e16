// Extracts the surfaces of a scene graph.
#pragma once

#include <string>

#include "io/model.h"

class SoNode;

namespace resect {

// Who turns shapes into triangles. Converted: Resect's own converters, which check ranges; Coin for
// kinds of shape that have no such converter. ByCoin: Coin for all shapes; a reference for tests,
// safe for valid scenes only.
enum class ShapeReading { Converted, ByCoin };

// Adds to model.parts the triangles of all shapes that would be drawn. Switch, LevelOfDetail, USE,
// Array, Units and all transforms are followed. Lines, points, flat text and draggers are left out.
// A shape's triangles go to the part with the shape's DEF name; if it has none, with that of the
// innermost node round it that has one. A part has normals where a TriangleStripSet gives each
// point one, and the material of its first shape. Sets model.places if the scene is one that Resect
// saved. Throws an Error about model.path if a count or an index in the scene is out of range, or
// if the scene has more than 20 million triangles. The caller must hold a reference to `root`
// (SoNode::ref()).
void addScene(SoNode* root, ShapeReading reading, Model& model);

}  // namespace resect
