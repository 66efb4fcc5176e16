// Reads .off files (Object File Format of Geomview), as text.
//
// Source: "OFF: file format for a surface", Geomview manual, section 4.2.5.
#pragma once

#include <string>
#include <string_view>

#include "io/model.h"

namespace resect {

// Whether the first word of the bytes is OFF, as in a .off file. Letters before OFF may name
// further values of the points: COFF means that the points have colours.
bool startsAsOff(std::string_view bytes);

// The model has one part, without a name. Each point and each face of the file is on a line of its
// own. What follows the coordinates or the corners on the line (normals, colours) is ignored.
// Coordinates are taken as metres. Throws Error if the file ends early, if it is binary, or if its
// points have four or more dimensions.
Model readOffFile(const std::string& path, std::string_view bytes);

}  // namespace resect
