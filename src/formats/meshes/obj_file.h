// Reads Wavefront .obj files.
//
// Source: "Object Files (.obj)", appendix B1 of the manual of Advanced Visualizer (Wavefront).
#pragma once

#include <string>
#include <string_view>

#include "io/model.h"

namespace resect {

// The model has one part per object (o) or group (g) name. The name is the whole rest of the line,
// spaces included. A line o or g begins the next part; g without a name returns to the part of the
// object. Polygons become triangles; points, lines, free-form curves and materials are left out.
// Numbers are taken as metres. Keywords may be in capitals. Throws Error if a vertex or a face is
// incomplete, or if a face uses a point that does not exist.
Model readObjFile(const std::string& path, std::string_view bytes);

}  // namespace resect
