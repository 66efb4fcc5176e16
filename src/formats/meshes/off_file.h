// Reads .off files (Object File Format of Geomview), as text.
//
// Source: "OFF: file format for a surface", Geomview manual, section 4.2.5.
#pragma once

#include <string>
#include <string_view>

#include "io/model.h"

namespace resect {

// Whether the first word is that of a .off file: OFF, which may be preceded by letters for further
// values of the points, as in COFF.
bool startsAsOff(std::string_view bytes);

// The model has one part, without a name. Each point and each face has a line of its own. The rest
// of that line (normals, colours) is ignored. Numbers are taken as metres. Throws Error if the file
// ends early, is binary, or has points of four or more dimensions.
Model readOffFile(const std::string& path, std::string_view bytes);

}  // namespace resect
