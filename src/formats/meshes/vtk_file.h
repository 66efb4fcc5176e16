// Reads legacy VTK files of polygons.
//
// Source: "VTK File Formats" (Kitware, VTK User's Guide). Reads versions 1.0 to 5.1, as text or as
// big-endian binary. Reads POINTS, POLYGONS and TRIANGLE_STRIPS of DATASET POLYDATA. Skips
// vertices, lines and all attributes.
#pragma once

#include <string>
#include <string_view>

#include "io/model.h"

namespace resect {

// Whether the bytes begin as a legacy VTK file does.
bool isVtkFile(std::string_view bytes);

// The model has one part, without a name. Numbers are taken as metres. Every count and index is
// checked. Throws Error, which names the section of the file, if one is wrong.
Model readVtkFile(const std::string& path, std::string_view bytes);

}  // namespace resect
