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
  std::string_view bytes;     // of the file, as it is
  const BesideFiles& beside;  // the files that it is known to refer to
  SharedNumber& share;        // what has been read, 0 to 1; to be set by the reader
};

struct ForeignReading {
  double seconds = 5;      // of processor time, and 1 s more for each MB
  Progress progress = {};  // gets the share, or -1 while none is known
  // Runs in the child before the sandbox is entered (runInChild()).
  std::function<void(std::string_view bytes)> prepare = {};
};

// Runs `read` in a child process until it needs no further file beside the first one, and returns
// its answer. `read` says which file it needs by throwing LacksFile. Throws the Errors of
// readForeignFile() and runInChild(); and if the file and those beside it have more than 1 GB, or
// are more than 17.
std::string readForeign(const std::filesystem::path& path, const ForeignReading& how,
                        const std::function<std::string(const ForeignFile&)>& read);

}  // namespace resect
