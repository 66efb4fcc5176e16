// Finds out what the name of an output stands for: a file to replace, a device or pipe to write
// into, or an open descriptor, such as /dev/stdout.
#pragma once

#include <filesystem>
#include <string>

namespace resect {

struct OutputTarget {
  enum class Kind {
    File,       // ordinary file, new or to be replaced
    Stream,     // character device or named pipe: written into directly, never replaced
    Descriptor  // open descriptor of this process, such as /dev/stdout or /dev/fd/3
  };
  Kind kind = Kind::File;
  // For Kind::File: the name after symbolic links have been followed. For the other kinds: the name
  // as it was given.
  std::filesystem::path path;
  int descriptor = -1;  // number of the descriptor, for Kind::Descriptor only
};

// Finds the target of an output's name. The function opens and creates nothing, so it can be called
// before a long computation. Throws Error if `name` leads to a folder, a disk (block device), a
// socket or a write-protected file, or if `name` is a symbolic link that leads nowhere. Also throws
// Error if the folder of the output is write-protected. A folder that does not exist yet is no
// error.
OutputTarget findTarget(const std::filesystem::path& name);

// A text that identifies the file to which a name leads. Two names get the same text if and only if
// they lead to the same file, even if they are spelt differently or lead there by symbolic or hard
// links. "-" stands for standard output. As an exception, the text is empty for /dev/null, since
// several outputs may go there. For the same reason the text is empty for "-" if standard output is
// closed or leads to /dev/null.
std::string identityOf(const std::filesystem::path& name);

// Whether the name leads to standard output, as "-" and "/dev/stdout" do. An output that is written
// there would be mixed with the text that this program prints.
bool isStandardOutput(const std::filesystem::path& name);

}  // namespace resect
