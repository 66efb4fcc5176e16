// How is a file written so that nobody ever sees half of it?
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <span>
#include <string>

namespace resect {

// Lets `write` fill a temporary file beside `path`, then renames it to `path`. When `write` throws
// or the disk is full, the temporary file is removed, what stood at `path` before is untouched, and
// an Error says why. Creates missing folders.
void writeFileAtomically(const std::filesystem::path& path,
                         const std::function<void(std::ostream&)>& write);

// Before long work: throws an Error when nothing can be written to `path` because a folder stands
// there, or it or its folder is write-protected, and a usage Error when it is one of the files that
// are read (`inputs`; those that do not exist are passed over).
void checkTarget(const std::filesystem::path& path, std::span<const std::string> inputs = {});

}  // namespace resect
