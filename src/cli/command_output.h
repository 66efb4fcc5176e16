// Writes the JSON that a command puts out, to a file or to standard output.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace resect {

// target: name of the file, or "-" for standard output. Indents by two spaces and keeps the order
// in which keys were added. A file is written atomically (io/atomic_file.h).
void writeJson(const std::string& target, const nlohmann::ordered_json& json);

}  // namespace resect
