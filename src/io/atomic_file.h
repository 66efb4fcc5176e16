// Writes outputs: a reader of a file sees either the old file or the complete new one.
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>

namespace resect {

// Lets `write` fill a temporary file beside `path`, flushes that file to the disk and renames it to
// `path`. Creates missing folders. If something fails, the temporary file is removed, and an
// earlier file at `path` does not change. If writing fails, for example because the disk is full,
// throws an Error that says so. Exceptions that `write` throws are passed on. If `path` is a
// symbolic link, the link stays and the file to which it leads is replaced. If `path` is a device,
// a named pipe or /dev/stdout (io/output/output_target.h), `write` writes directly into it.
void writeFileAtomically(const std::filesystem::path& path,
                         const std::function<void(std::ostream&)>& write);

}  // namespace resect
