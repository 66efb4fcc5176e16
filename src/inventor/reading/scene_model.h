// Extracts the surfaces of a scene graph.
#pragma once

#include <string>

#include "io/model.h"

class SoNode;

namespace resect {

// Which code turns shapes into triangles. Converted: Resect's own converters, which check ranges,
// and Coin for kinds of shape that have no such converter. ByCoin: Coin for all shapes. ByCoin is a
// reference for tests and is safe for valid scenes only.
enum class ShapeReading { Converted, ByCoin };

// Adds to model.parts the triangles of all shapes that would be drawn. Switch, LevelOfDetail, USE,
// Array, Units and all transforms are applied. Lines, points, flat text and draggers are left out.
// A shape's triangles go to the part with the shape's DEF name. If the shape has no DEF name, they
// go to the part named after the innermost node round the shape that has one. A part gets the
// material of its first shape, and normals from each TriangleStripSet that has one normal per
// point. Sets model.places if the scene is one that Resect saved. Throws an Error about model.path
// if a count or an index in the scene is out of range, or if the scene has more than 20 million
// triangles. The caller must hold a reference to `root` (SoNode::ref()).
void addScene(SoNode* root, ShapeReading reading, Model& model);

}  // namespace resect
