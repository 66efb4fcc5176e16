// How is a file written so that nobody ever sees half of it?
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>

namespace resect {

// Lets `write` fill a temporary file beside `path`, then renames it to `path`. When `write` throws
// or the disk is full, the temporary file is removed, what stood at `path` before is untouched, and
// an Error says why. Creates missing folders.
void writeFileAtomically(const std::filesystem::path& path,
                         const std::function<void(std::ostream&)>& write);

}  // namespace resect
