// Guard for Inventor and VRML files: rejects text that crashes Coin.
#pragma once

#include <string>
#include <string_view>

namespace resect {

// Whether the bytes begin like an Inventor or VRML file ("#Inventor V", "#VRML V").
bool isInventorFile(std::string_view bytes);

// The format by the file's first line: "Inventor V2.1 binary", "VRML V1.0 ascii", "VRML V2.0 utf8".
// "Inventor" if the line does not begin with '#'.
std::string inventorFormat(std::string_view bytes);

// Scans a text file before Coin reads it. Throws Error, with the line, for what crashes Coin 4.0.0:
// nesting deeper than 500, words longer than 200 characters, a node used inside itself, a PROTO
// that contains itself. Also for brackets and strings that do not end. A binary file is not
// scanned. O(bytes). The guard is there for its sentences: the sandbox (formats/sandbox.h) contains
// crashes and keeps other files out.
void guardInventorFile(const std::string& path, std::string_view bytes);

}  // namespace resect
