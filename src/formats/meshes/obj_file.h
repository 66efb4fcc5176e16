// Reads Wavefront .obj files.
//
// Source: "Object Files (.obj)", appendix B1 of the manual of Advanced Visualizer (Wavefront).
#pragma once

#include <string>
#include <string_view>

#include "io/model.h"

namespace resect {

// One part per object (o) or group (g), by its whole name, spaces included. A line o or g begins
// the next part; g without a name goes back to the object. Polygons become triangles; points,
// lines, free-form curves and all looks are left out. Numbers are taken as metres. Keywords may be
// in capitals. Throws Error if a vertex or a face is not complete or uses a point that is not
// there.
Model readObjFile(const std::string& path, std::string_view bytes);

}  // namespace resect
