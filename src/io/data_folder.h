// Finds the files that are shipped with Resect: instruments, organs, scenarios, shaders.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace resect {

// The data folder: $RESECT_DATA if that is set (an Error if it names no data folder); else the one
// beside the program, installed or in its build tree; else the one of the sources that the program
// was built from; else the one of the install location. If there is none, an Error lists the
// folders that were tried.
std::filesystem::path dataFolder();

// The file `name` if it exists; else the shipped file of that name and extension in dataFolder() /
// folder. If there is none, an Error lists the shipped names.
std::filesystem::path findDataFile(const std::string& name, const std::string& folder,
                                   const std::string& extension);

// The names, sorted and without extension, of the shipped files in `folder` that have this
// extension.
std::vector<std::string> shippedNames(const std::string& folder, const std::string& extension);

}  // namespace resect
