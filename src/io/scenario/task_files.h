// The scenarios and tasks that come with Resect, by name.
#pragma once

#include <filesystem>
#include <string>

namespace resect {

// `name` itself if there is a file of this name; else the shipped scenario or task of that name. If
// there is neither, an Error lists the shipped scenarios.
std::filesystem::path findScenario(const std::string& name);

}  // namespace resect
