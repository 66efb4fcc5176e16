// Report about a file of particles, for the command `resect info`.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "io/cells/cells_file.h"

namespace resect {

// The report as JSON. Lengths are in m, volumes in ml, landmarks in fractions of the organ's box.
// kept: the content of the file. path: the file's name, which is shown; its extension gives the
// format.
nlohmann::ordered_json toJson(const KeptCells& kept, const std::string& path);

// The report as text, one fact in each line.
std::string toText(const KeptCells& kept, const std::string& path);

}  // namespace resect
