// Which surface does a legacy VTK file of polygons hold?
//
// "VTK File Formats" (Kitware, VTK User's Guide): text and big-endian binary, versions 1.0 to 5.1,
// DATASET POLYDATA with POINTS, POLYGONS and TRIANGLE_STRIPS; vertices, lines and all attributes
// are skipped.
#pragma once

#include <string>
#include <string_view>

#include "io/model.h"

namespace resect {

// Does it begin as such a file does?
bool isVtkFile(std::string_view bytes);

// One part without a name. Metres, whatever the file means by its numbers. Every count and index is
// checked; an Error names the section.
Model readVtkFile(const std::string& path, std::string_view bytes);

}  // namespace resect
