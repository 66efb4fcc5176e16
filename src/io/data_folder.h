// Finds the files that are shipped with Resect: tools, room, scenarios.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace resect {

// $RESECT_DATA, else the folder beside the program (installed or in its build tree), else the
// sources that it was built from, else its install location. If there is none, an Error lists the
// folders that were tried.
std::filesystem::path dataFolder();

// The file `name` if it exists; else the shipped file of that name and extension in dataFolder() /
// folder. If there is none, an Error lists the shipped names.
std::filesystem::path findDataFile(const std::string& name, const std::string& folder,
                                   const std::string& extension);

// Names (without extension) of the shipped files of a kind, sorted.
std::vector<std::string> shippedNames(const std::string& folder, const std::string& extension);

}  // namespace resect
