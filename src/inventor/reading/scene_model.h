// Extracts the surfaces of a scene graph.
#pragma once

#include <string>

#include "io/model.h"

class SoNode;

namespace resect {

// How shapes become triangles. Converted: by our own range-checked converters where there is one,
// else by Coin. ByCoin: all by Coin, as a reference for tests; safe for valid scenes only.
enum class ShapeReading { Converted, ByCoin };

// Adds to model.parts the triangles of all shapes that would be drawn. Switch, LevelOfDetail, USE,
// Array, Units and all transforms are followed; lines, points, flat text and draggers are left out.
// A part is named by the innermost DEF around its shape. Throws an Error about model.path if a
// count or an index in the scene is out of range, or the scene has more than 20 million triangles.
// `root` must be referenced.
void addScene(SoNode* root, ShapeReading reading, Model& model);

}  // namespace resect
