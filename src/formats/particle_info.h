// Report about a file of particles, for the command `resect info`.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "io/cells/cells_file.h"

namespace resect {

// The report as JSON. Lengths are in m, volumes in ml, landmarks in fractions of the organ's box.
// kept: what the file holds. path: the file's name; it is shown, and its extension tells the
// format.
nlohmann::ordered_json toJson(const KeptCells& kept, const std::string& path);

// The report as a few lines of text.
std::string toText(const KeptCells& kept, const std::string& path);

}  // namespace resect
