// Reads .ply files (Stanford polygon files). They may be text, or binary in either byte order.
//
// Source: "The PLY Polygon File Format" (Greg Turk, Stanford, 1994).
#pragma once

#include <string>
#include <string_view>

#include "io/model.h"

namespace resect {

// Whether the bytes begin as a .ply file does.
bool startsAsPly(std::string_view bytes);

// The model has one part, without a name. The points come from the properties x, y and z of the
// element `vertex`. The faces come from the list vertex_indices or vertex_index of the element
// `face`. Strips of triangles come from a list with one of these two names in the element
// `tristrips`. The elements may come in any order. All other elements and properties are skipped,
// and so are bytes after the last element. Coordinates are taken as metres. Throws Error if the
// header is damaged, if the file ends early, or if the file has points but no faces.
Model readPlyFile(const std::string& path, std::string_view bytes);

}  // namespace resect
