// Writes outputs: a reader of a file sees either the old file or the complete new one.
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>

namespace resect {

// Lets `write` fill a temporary file beside `path`, puts that file on the disk and renames it to
// `path`. Creates missing folders. If something fails, the temporary file is removed, and an
// earlier file at `path` stays as it was. A failure to write (as on a full disk) gives an Error
// that says so; what `write` throws is passed on. A symbolic link stays: the file to which it leads
// is replaced. Into devices, named pipes and /dev/stdout `write` writes straight
// (io/output/output_target.h); they stay what they are.
void writeFileAtomically(const std::filesystem::path& path,
                         const std::function<void(std::ostream&)>& write);

}  // namespace resect
