// A file that is written under a temporary name beside its target and renamed when it is complete.
#pragma once

#include <filesystem>

namespace resect {

class TemporaryFile {
 public:
  // Creates an empty file with a random name in the folder of `target`. Never opens a file or
  // follows a link that already has this name. Throws Error if the folder cannot be written.
  explicit TemporaryFile(const std::filesystem::path& target);
  // Removes the file, unless it was renamed.
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  int descriptor() const { return descriptor_; }               // open for reading and writing
  const std::filesystem::path& path() const { return path_; }  // until it is renamed

  // Renames the file to the target. If the target exists, it is replaced; the file takes over the
  // target's permissions, and the target's owner if this process may set it. Before the renaming
  // all bytes are synchronised to the disk (fsync), afterwards the folder. Throws Error if this
  // fails; the target is then unchanged.
  void rename();
  // The same, but throws Error if the target exists, and never replaces it.
  void publish();

 private:
  void sync();
  void settle();

  std::filesystem::path target_, path_;
  int descriptor_ = -1;
  int slot_ = -1;  // in the list of removeTemporaryFiles()
};

// Removes every TemporaryFile of this process from its folder. This function is async-signal-safe:
// handlers of signals that end the process call it. Does nothing in a forked child. If there are
// more than 16 such files at once, only 16 of them are removed.
void removeTemporaryFiles() noexcept;

}  // namespace resect
