// Extracts the surfaces of a scene graph.
#pragma once

#include <string>

#include "io/model.h"

class SoNode;

namespace resect {

// How shapes become triangles: by our own range-checked converters where they exist, or all by
// Coin, which is the reference in tests and is safe for valid scenes only.
enum class ShapeReading { Converted, ByCoin };

// The triangles of all shapes that would be drawn: Switch, LevelOfDetail, USE, Array, Units and all
// transforms are followed; lines, points, flat text and draggers are left out. A part is named by
// the innermost DEF around its shape. Throws an Error about model.path when a count or an index in
// the scene is out of range, or if the scene is too large. `root` must be referenced. Adds to
// model.parts.
void addScene(SoNode* root, ShapeReading reading, Model& model);

}  // namespace resect
