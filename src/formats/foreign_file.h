// Opens a file of others for reading: an ordinary file or nothing.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "base/raw_array.h"

namespace resect {

// All bytes of an ordinary file. Never waits, so a FIFO or a device is refused at once. Throws
// Error for anything else than an ordinary file, one of more than `most` bytes, and one that
// cannot be read.
RawArray<char> readForeignFile(const std::filesystem::path& path, std::size_t most);

// The same for a file that `path` refers to by `name`, such as a buffer of a .gltf. It must be a
// file in the same folder: a `name` with a slash or that is a link is refused.
RawArray<char> readForeignFileBeside(const std::filesystem::path& path, const std::string& name,
                                     std::size_t most);

}  // namespace resect
