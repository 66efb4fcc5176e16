// Reads legacy VTK files of polygons.
//
// Source: "VTK File Formats" (Kitware, VTK User's Guide). Supported: text and big-endian binary,
// versions 1.0 to 5.1, DATASET POLYDATA with POINTS, POLYGONS and TRIANGLE_STRIPS; vertices, lines
// and all attributes are skipped.
#pragma once

#include <string>
#include <string_view>

#include "io/model.h"

namespace resect {

// Whether the bytes begin as a legacy VTK file does.
bool isVtkFile(std::string_view bytes);

// The model has one part, without a name. Numbers are taken as metres. Every count and index is
// checked; an Error names the section of the file.
Model readVtkFile(const std::string& path, std::string_view bytes);

}  // namespace resect
