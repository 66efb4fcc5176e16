// Reads all bytes of a file.
#pragma once

#include <filesystem>
#include <string>

namespace resect {

// Throws Error when the file does not exist, is a folder, or cannot be read.
std::string readWholeFile(const std::filesystem::path& path, std::size_t most = 1 << 30);

}  // namespace resect
