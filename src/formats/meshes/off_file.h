// Reads .off files (Object File Format of Geomview), as text.
//
// Source: "OFF: file format for a surface", Geomview manual, section 4.2.5.
#pragma once

#include <string>
#include <string_view>

#include "io/model.h"

namespace resect {

// Whether the first word is one of a .off file: OFF, or with what its points also have, as COFF.
bool startsAsOff(std::string_view bytes);

// One part without a name. Each point and each face has a line of its own; what follows its numbers
// there (normals, colours) is ignored. Numbers are taken as metres. Throws Error if the file ends
// early, is binary, or has points of four or more dimensions.
Model readOffFile(const std::string& path, std::string_view bytes);

}  // namespace resect
