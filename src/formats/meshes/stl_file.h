// Reads .stl files, binary and text.
//
// Source: "StereoLithography Interface Specification" (3D Systems, 1989).
#pragma once

#include <string>
#include <string_view>

#include "io/model.h"

namespace resect {

// Whether the bytes can only be a binary STL: the file has exactly the size that its count of
// triangles implies.
bool isExactBinaryStl(std::string_view bytes);
// Whether the bytes begin like a text STL: "solid" in upper or lower case.
bool startsAsTextStl(std::string_view bytes);

// A text file gives one part per solid, with the solid's name; solids with the same name are one
// part. A binary file gives one part without a name. Numbers are taken as metres. Bytes after the
// last triangle of a binary file are ignored. Throws Error if the file ends early.
Model readStlFile(const std::string& path, std::string_view bytes);

}  // namespace resect
