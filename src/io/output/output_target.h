// What the name of an output stands for: a file to replace, a device or pipe to write into, or an
// open descriptor as /dev/stdout.
#pragma once

#include <filesystem>
#include <string>

namespace resect {

struct OutputTarget {
  enum class Kind {
    File,       // ordinary file, new or to be replaced
    Stream,     // character device or named pipe: written straight into, stays what it is
    Descriptor  // of this process: /dev/stdout, /dev/fd/3
  };
  Kind kind = Kind::File;
  std::filesystem::path
      path;             // File: where the bytes belong, symbolic links followed; else as given
  int descriptor = -1;  // of Kind::Descriptor
};

// Opens and creates nothing: to be called before long work. Throws Error if nothing can be written
// there: a folder, a disk, a socket, a link that leads nowhere, something write-protected, in a
// folder that is write-protected. Folders that do not exist are fine.
OutputTarget findTarget(const std::filesystem::path& name);

// Text that is the same for two names if and only if they stand for one file, however they are
// spelt: by links, hard links, `a/../b`; "-" is standard output. Empty for what is written any
// number of times without harm: /dev/null, and "-" where standard output is closed.
std::string identityOf(const std::filesystem::path& name);

// Whether what is written to that name ("-", "/dev/stdout") mixes with what this program prints.
bool isStandardOutput(const std::filesystem::path& name);

}  // namespace resect
