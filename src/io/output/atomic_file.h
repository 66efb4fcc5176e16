// Writes files atomically: a reader sees either the old file or the complete new file.
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>

namespace resect {

// Creates a temporary file beside `path`, calls `write` to fill it, flushes it to the disk, and
// renames it to `path`. Creates missing folders. If writing fails, for example because the disk is
// full, throws an Error that says why. Exceptions that `write` throws are passed on. In both cases
// the temporary file is removed, and an earlier file at `path` stays as it was. If `path` is a
// symbolic link, the file to which the link leads is replaced, and the link stays. If `path` is a
// device, a named pipe or /dev/stdout (io/output/output_target.h), there is no temporary file:
// `write` writes directly into the device, pipe or standard output.
void writeFileAtomically(const std::filesystem::path& path,
                         const std::function<void(std::ostream&)>& write);

}  // namespace resect
