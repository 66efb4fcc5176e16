// Writes a command's JSON to a file, or for "-" to standard output.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace resect {

// Indents by two spaces and keeps the order in which keys were added. Files are written atomically.
void writeJson(const std::string& target, const nlohmann::ordered_json& json);

}  // namespace resect
