// Reads all bytes of a file.
#pragma once

#include <filesystem>
#include <string>

namespace resect {

// Throws Error if `path` is not an ordinary file, if it cannot be read, or if it has more than
// `most` bytes.
std::string readWholeFile(const std::filesystem::path& path, std::size_t most = 1 << 30);

}  // namespace resect
