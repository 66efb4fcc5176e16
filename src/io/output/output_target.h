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
  std::filesystem::path path;  // File: the name after following symbolic links; otherwise as given
  int descriptor = -1;         // of Kind::Descriptor
};

// Finds the target of an output's name. To be called before long work: it opens and creates
// nothing. Throws Error if the name is that of a folder, a disk (block device), a socket, a
// symbolic link that leads nowhere or a write-protected file, or if the folder is write-protected.
// Folders that do not exist yet are no error.
OutputTarget findTarget(const std::filesystem::path& name);

// A text that identifies the file to which a name leads. Two names get the same text if and only if
// they lead to the same file, even if they are spelt differently or lead there by symbolic or hard
// links. "-" stands for standard output. The text is empty if several outputs may be written there:
// for /dev/null, and for "-" if standard output is closed.
std::string identityOf(const std::filesystem::path& name);

// Whether the name leads to standard output, as "-" and "/dev/stdout" do. An output there would be
// mixed with the text that this program prints.
bool isStandardOutput(const std::filesystem::path& name);

}  // namespace resect
