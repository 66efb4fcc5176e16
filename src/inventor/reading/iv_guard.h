// Guard for Inventor and VRML files: rejects text that would crash Coin.
#pragma once

#include <string>
#include <string_view>

namespace resect {

// Whether the bytes begin like an Inventor or VRML file ("#Inventor V", "#VRML V").
bool isInventorFile(std::string_view bytes);

// The format that the first line of the file names, for example "Inventor V2.1 binary", "VRML V1.0
// ascii" or "VRML V2.0 utf8". "Inventor" if the line does not begin with '#'.
std::string inventorFormat(std::string_view bytes);

// Scans a text file before Coin reads it. Throws an Error that gives the number of the line, if the
// text has something that crashes Coin 4.0.0: nesting deeper than 500, a word longer than 200
// characters, a node used inside itself, or a PROTO that contains itself. Brackets without a
// partner and strings without an end are errors too. A binary file is not scanned. O(bytes). The
// guard serves its error messages, not safety: the sandbox (formats/child/sandbox.h) contains
// crashes and refuses access to other files.
void guardInventorFile(const std::string& path, std::string_view bytes);

}  // namespace resect
