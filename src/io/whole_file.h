// Reads all bytes of a file.
#pragma once

#include <filesystem>
#include <string>

namespace resect {

// Throws Error when there is no such file, or it is a folder, or it cannot be read.
std::string readWholeFile(const std::filesystem::path& path);

}  // namespace resect
