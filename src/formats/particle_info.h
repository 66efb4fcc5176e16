// Reports about particle files (io/cells/particle_file.h), for the command `resect info`.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "io/cells/cells_file.h"

namespace resect {

// The report as JSON. Lengths are in m and volumes in ml. Coordinates of landmarks are fractions of
// the organ's box. kept: the content of the file. path: the name of the file; the report shows it,
// and names the format by its extension.
nlohmann::ordered_json toJson(const KeptCells& kept, const std::string& path);

// The report as text, with one fact in each line.
std::string toText(const KeptCells& kept, const std::string& path);

}  // namespace resect
