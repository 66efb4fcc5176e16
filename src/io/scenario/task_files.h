// Finds scenarios and tasks (exercises) that come with Resect by their names.
#pragma once

#include <filesystem>
#include <string>

namespace resect {

// If there is a file with the name `name`, returns `name` itself. Otherwise returns the file of the
// shipped task or scenario with this name. If there is no such task or scenario, throws an Error
// that lists the shipped scenarios.
std::filesystem::path findScenario(const std::string& name);

}  // namespace resect
