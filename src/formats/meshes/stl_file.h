// Reads .stl files, binary and text.
//
// Source: "StereoLithography Interface Specification" (3D Systems, 1989).
#pragma once

#include <string>
#include <string_view>

#include "io/model.h"

namespace resect {

// Whether the number of bytes is exactly that of a binary STL with the number of triangles in the
// header. Then the file cannot be text.
bool isExactBinaryStl(std::string_view bytes);
// Whether the bytes begin with "solid", in upper or lower case, as a text STL does.
bool startsAsTextStl(std::string_view bytes);

// If the file is text, the model has one part for each name of a solid. Solids with equal names
// become one part. If the file is binary, the model has one part, without a name, and bytes after
// the last triangle are ignored. Coordinates are taken as metres. Throws Error if the file ends
// early.
Model readStlFile(const std::string& path, std::string_view bytes);

}  // namespace resect
