// Reads .stl files, binary and text.
//
// Source: "StereoLithography Interface Specification" (3D Systems, 1989).
#pragma once

#include <string>
#include <string_view>

#include "io/model.h"

namespace resect {

// Whether these bytes can only be a binary STL: their number is exactly the one that the count of
// triangles in them asks for.
bool isExactBinaryStl(std::string_view bytes);
// Whether the bytes begin as a text STL does: "solid" in any case.
bool startsAsTextStl(std::string_view bytes);

// One part per solid of a text file, named as the solid is; solids of one name are one part. A
// binary file has one part without a name. Numbers are taken as metres. Bytes after the last
// triangle of a binary file are ignored. Throws Error if the file ends early.
Model readStlFile(const std::string& path, std::string_view bytes);

}  // namespace resect
