// Reads legacy VTK files that contain polygons.
//
// The files may have version 1.0 to 5.1, and may be text or big-endian binary. The sections POINTS,
// POLYGONS and TRIANGLE_STRIPS of DATASET POLYDATA are read. All other sections are skipped,
// such as VERTICES, LINES and attributes.
//
// Source: "VTK File Formats" (Kitware, VTK User's Guide).
#pragma once

#include <string>
#include <string_view>

#include "io/model.h"

namespace resect {

// Whether the bytes begin as a legacy VTK file does.
bool isVtkFile(std::string_view bytes);

// The model has one part, without a name. Coordinates are taken as metres. If a count or an index
// is wrong, throws an Error that names the section of the file.
Model readVtkFile(const std::string& path, std::string_view bytes);

}  // namespace resect
