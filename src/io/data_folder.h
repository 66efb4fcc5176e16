// Where are the files that come with Resect: tools, room, scenarios?
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace resect {

// $RESECT_DATA, else the folder beside the program (installed or in its build tree), else the
// sources that it was built from, else where it was to be installed. An Error names the places
// looked at when there is none.
std::filesystem::path dataFolder();

// A file that a person names: as it is when it exists; else `name` with the extension in
// dataFolder() / folder. An Error lists what there is to choose from.
std::filesystem::path findDataFile(const std::string& name, const std::string& folder,
                                   const std::string& extension);

// Names (without extension) of the shipped files of a kind, sorted.
std::vector<std::string> shippedNames(const std::string& folder, const std::string& extension);

}  // namespace resect
