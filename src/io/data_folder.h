// Finds the files that come with Resect (shipped files): instruments, organs, scenarios, shaders.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace resect {

// The data folder, which is the first of these that exists:
// 1. the folder that the environment variable RESECT_DATA names; if it is set and does not name a
//    data folder, throws Error;
// 2. the folder beside the program, where the program is installed or in its build tree;
// 3. the folder of the sources that the program was built from;
// 4. the folder of the install location.
// If none exists, throws an Error that lists the folders that were tried.
std::filesystem::path dataFolder();

// Returns `name` itself if there is a file with this name. Otherwise returns the shipped file
// dataFolder() / folder / (name + extension); `extension` begins with a dot. If neither file
// exists, throws an Error that lists the shipped names.
std::filesystem::path findDataFile(const std::string& name, const std::string& folder,
                                   const std::string& extension);

// The names of the shipped files in `folder` that have this extension. The names are sorted and
// come without the extension.
std::vector<std::string> shippedNames(const std::string& folder, const std::string& extension);

}  // namespace resect
