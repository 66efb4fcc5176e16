// Atomic writing of files: readers see the old file or the complete new one.
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <span>
#include <string>

namespace resect {

// Lets `write` fill a temporary file beside `path`, then renames it to `path`. When `write` throws
// or the disk is full, the temporary file is removed, an earlier file at `path` is untouched, and
// an Error says why. Creates missing folders.
void writeFileAtomically(const std::filesystem::path& path,
                         const std::function<void(std::ostream&)>& write);

// To be called before long work: throws Error if `path` cannot be written because it is a folder,
// or it or its folder is write-protected, and a usage Error if it is one of the files to be read
// (`inputs`; missing ones are ignored).
void checkTarget(const std::filesystem::path& path, std::span<const std::string> inputs = {});

}  // namespace resect
