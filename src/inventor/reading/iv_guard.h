// Would this Inventor or VRML file kill its reader, or make it open other files?
#pragma once

#include <string>
#include <string_view>

namespace resect {

// Does it begin as an Inventor or VRML file does ("#Inventor V", "#VRML V")?
bool isInventorFile(std::string_view bytes);

// The header as a name: "Inventor V2.1 binary", "VRML V1.0 ascii", "VRML V2.0 utf8"; "Inventor"
// when it says nothing more.
std::string inventorFormat(std::string_view bytes);

// Looks over the bytes before Coin does and throws an Error, with the line, for what Coin 4.0.0
// does not survive: nesting deeper than 500, words longer than 200 characters, a node used inside
// itself, a PROTO that holds itself; and for what would open another file: File, Inline, WWWInline,
// EXTERNPROTO. A binary file is only searched for nodes that open files. O(bytes).
void guardInventorFile(const std::string& path, std::string_view bytes);

}  // namespace resect
