// Which surfaces does a scene graph show?
#pragma once

#include <string>

#include "io/model.h"

class SoNode;

namespace resect {

// How shapes become triangles: our own converters where there are some (range-checked), or Coin's
// triangles for every shape, which the converters are tested against and which must only be asked
// of scenes that are sound.
enum class ShapeReading { Converted, ByCoin };

// The triangles of all shapes that would be drawn: Switch, LevelOfDetail, USE, Array, Units and all
// transforms are followed; lines, points, flat text and draggers are left out. A part is named by
// the innermost DEF around its shape. Throws an Error about model.path when a count or an index in
// the scene is out of range, or when there is too much of it. `root` must be referenced.
// Adds to model.parts.
void addScene(SoNode* root, ShapeReading reading, Model& model);

}  // namespace resect
