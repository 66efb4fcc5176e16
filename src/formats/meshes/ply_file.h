// Reads .ply files (Stanford polygon files), as text and as binary of both byte orders.
//
// Source: "The PLY Polygon File Format" (Greg Turk, Stanford, 1994).
#pragma once

#include <string>
#include <string_view>

#include "io/model.h"

namespace resect {

// Whether the bytes begin as a .ply file does.
bool startsAsPly(std::string_view bytes);

// The model has one part, without a name, from the elements `vertex` (x, y, z) and `face` or
// `tristrips` (vertex_indices or vertex_index), which may come in any order. All other elements and
// properties, and any bytes after the last element, are skipped. Numbers are taken as metres.
// Throws Error if the header is damaged, if the file ends early, or if it has points only.
Model readPlyFile(const std::string& path, std::string_view bytes);

}  // namespace resect
