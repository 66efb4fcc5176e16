// Finds the files that come with Resect (shipped files): instruments, organs, scenarios, shaders.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace resect {

// Returns the data folder: the first of these folders that exists.
// 1. The folder that the environment variable RESECT_DATA names. If the variable is set but does
//    not name a data folder, throws Error.
// 2. The data folder beside the program. It exists in a build tree and in an installation.
// 3. The data folder of the sources from which the program was built.
// 4. The data folder of the install location.
// If no such folder exists, throws an Error that lists the folders that were tried.
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
