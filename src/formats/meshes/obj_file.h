// Reads Wavefront .obj files.
//
// Source: "Object Files (.obj)", appendix B1 of the manual of Advanced Visualizer (Wavefront).
#pragma once

#include <string>
#include <string_view>

#include "io/model.h"

namespace resect {

// A line with the keyword `o` names an object, and a line with the keyword `g` names a group. The
// name is the rest of the line and may contain spaces. Each face belongs to the part whose name
// stands in the last such line before the face. After a line `g` without a name, the part has the
// name of the object. Faces under equal names belong to one part. Polygons become triangles.
// Points, lines, free-form curves and materials are left out. Coordinates are taken as metres.
// Keywords may be in upper or lower case. Throws Error if a vertex or a face is incomplete, or if a
// face uses a point that does not exist.
Model readObjFile(const std::string& path, std::string_view bytes);

}  // namespace resect
