// Writes files atomically: a reader sees either the old file or the complete new one.
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <span>
#include <string>

namespace resect {

// Lets `write` fill a temporary file beside `path`, then renames this file to `path`. Creates
// missing folders. If something fails, the temporary file is removed, and an earlier file at `path`
// stays as it was. A failure to write (as on a full disk) gives an Error that says so; what `write`
// throws is passed on.
void writeFileAtomically(const std::filesystem::path& path,
                         const std::function<void(std::ostream&)>& write);

// To be called before long work whose result goes to `path`. Throws Error if `path` is a folder, or
// if the file or its folder is write-protected. inputs: files that the work reads; those that do
// not exist are ignored. Throws a usage Error if `path` is one of them.
void checkTarget(const std::filesystem::path& path, std::span<const std::string> inputs = {});

}  // namespace resect
