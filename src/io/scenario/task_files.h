// Finds the scenarios and tasks that come with Resect by their names.
#pragma once

#include <filesystem>
#include <string>

namespace resect {

// Returns `name` itself if there is a file with this name; otherwise the file of the shipped
// scenario or task with this name. If there is neither, throws an Error that lists the shipped
// scenarios.
std::filesystem::path findScenario(const std::string& name);

}  // namespace resect
