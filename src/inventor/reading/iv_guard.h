// Checks Inventor and VRML files: rejects texts that would crash Coin, the library that reads them.
#pragma once

#include <string>
#include <string_view>

namespace resect {

// Whether the bytes begin with "#Inventor V" or "#VRML V", as an Inventor or VRML file does.
bool isInventorFile(std::string_view bytes);

// The format according to the first line of the file, for example "Inventor V2.1 binary", "VRML
// V1.0 ascii" or "VRML V2.0 utf8". If the line does not begin with '#', the result is "Inventor".
std::string inventorFormat(std::string_view bytes);

// Scans a text file before Coin reads it. Throws an Error with the number of the line if the text
// contains something that crashes Coin 4.0.0: brackets nested more than 500 deep, a word of more
// than 200 characters, a node that is used inside itself, or a PROTO that contains itself. Also
// throws Error for brackets without a partner and for strings without an end. A binary file is not
// scanned. Cost: O(n) for n bytes. This function is not needed for safety, but it gives better
// error messages. For safety, files are read in a sandbox (formats/child/sandbox.h): a crash there
// does no harm, and the sandbox refuses access to other files.
void guardInventorFile(const std::string& path, std::string_view bytes);

}  // namespace resect
