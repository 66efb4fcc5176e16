// Guard for Inventor and VRML files: rejects text that crashes Coin.
#pragma once

#include <string>
#include <string_view>

namespace resect {

// Whether the bytes begin like an Inventor or VRML file ("#Inventor V", "#VRML V").
bool isInventorFile(std::string_view bytes);

// The header as a name: "Inventor V2.1 binary", "VRML V1.0 ascii", "VRML V2.0 utf8"; "Inventor" if
// it has no version.
std::string inventorFormat(std::string_view bytes);

// Scans the text before Coin reads it and throws Error, with the line, for what crashes Coin 4.0.0:
// nesting deeper than 500, words longer than 200 characters, a node used inside itself, a PROTO
// that contains itself; and for brackets and strings that are never closed. A binary file is not
// looked at. O(bytes). It makes sentences out of crashes; what holds a crash, and what keeps other
// files out, is the sandbox (formats/sandbox.h).
void guardInventorFile(const std::string& path, std::string_view bytes);

}  // namespace resect
