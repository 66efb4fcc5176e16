// Reads a foreign file, and the files that it refers to, in a sandboxed child process.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "base/progress.h"
#include "formats/beside_files.h"
#include "formats/child/child_process.h"

namespace resect {

struct ForeignFile {
  std::string_view bytes;     // content of the file
  const BesideFiles& beside;  // the files to which it refers, as far as they are loaded
  SharedNumber& share;        // fraction read so far, 0 to 1; -1: unknown; set by the reader
};

struct ForeignReading {
  double seconds = 5;      // limit of processor time, s; plus 1 s for each MB of the files
  Progress progress = {};  // gets ForeignFile::share
  // Runs in the child before the sandbox is entered (runInChild()).
  std::function<void(std::string_view bytes)> prepare = {};
};

// Runs `read` in a child process and returns its result. If `read` throws LacksFile, the named file
// is loaded and `read` runs again, in a new child process. Passes on the Errors of
// readForeignFile() and runInChild(). Also throws Error if `read` needs more than 16 files besides
// the first file, or if all files together have more than 1 GB.
std::string readForeign(const std::filesystem::path& path, const ForeignReading& how,
                        const std::function<std::string(const ForeignFile&)>& read);

}  // namespace resect
