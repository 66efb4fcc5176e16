// Writes files atomically: a reader sees either the old file or the complete new one.
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <span>
#include <string>

namespace resect {

// Lets `write` fill a temporary file beside `path`, then renames it to `path`. Creates missing
// folders. If the disk is full, throws an Error that says so; what `write` throws is passed on. In
// both cases the temporary file is removed, and an earlier file at `path` stays as it was.
void writeFileAtomically(const std::filesystem::path& path,
                         const std::function<void(std::ostream&)>& write);

// Call it before long work whose result goes to `path`. Throws Error if `path` is a folder, or if
// the file or its folder is write-protected. Throws a usage Error if it is one of `inputs`, the
// files to be read; missing ones are ignored.
void checkTarget(const std::filesystem::path& path, std::span<const std::string> inputs = {});

}  // namespace resect
