// Report about a file of particles, for `resect info`.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "io/cells/cells_file.h"

namespace resect {

// Lengths in m, volumes in ml. `path` is shown as the file's name.
nlohmann::ordered_json toJson(const KeptCells& kept, const std::string& path);

// A few lines for a person.
std::string toText(const KeptCells& kept, const std::string& path);

}  // namespace resect
