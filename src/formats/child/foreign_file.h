// Reads files that other programs made. Only ordinary files are read: no folders, devices or FIFOs.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "base/raw_array.h"

namespace resect {

enum class Links { Followed, Refused };

// Returns all bytes of the file. Throws Error if the path is not an ordinary file, if the file has
// more than `most` bytes, or if it cannot be read. With Links::Followed, the path may also be a
// link to an ordinary file. The function never waits: a FIFO or a device is refused immediately.
RawArray<char> readForeignFile(const std::filesystem::path& path, std::size_t most,
                               Links links = Links::Followed);

// The same for a second file, to which the file at `path` refers by `name`. For example, a .gltf
// file refers to its buffers in this way. The second file must lie in the same folder and must not
// be a link. `name` is refused if it is empty, begins with a dot, or contains a slash or a control
// character.
RawArray<char> readForeignFileBeside(const std::filesystem::path& path, const std::string& name,
                                     std::size_t most);

}  // namespace resect
