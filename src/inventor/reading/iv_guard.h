// Guard for Inventor and VRML files: rejects content that crashes Coin or opens other files.
#pragma once

#include <string>
#include <string_view>

namespace resect {

// Whether the bytes begin like an Inventor or VRML file ("#Inventor V", "#VRML V").
bool isInventorFile(std::string_view bytes);

// The header as a name: "Inventor V2.1 binary", "VRML V1.0 ascii", "VRML V2.0 utf8"; "Inventor" if
// it has no version.
std::string inventorFormat(std::string_view bytes);

// Scans the bytes before Coin reads them and throws Error, with the line, for what crashes Coin
// 4.0.0: nesting deeper than 500, words longer than 200 characters, a node used inside itself, a
// PROTO that contains itself; and for what would open another file: File, Inline, WWWInline,
// EXTERNPROTO. A binary file is only searched for nodes that open files. O(bytes).
void guardInventorFile(const std::string& path, std::string_view bytes);

}  // namespace resect
