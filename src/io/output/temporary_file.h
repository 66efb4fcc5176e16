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
  const std::filesystem::path& path() const { return path_; }  // valid until it is renamed

  // Renames the file to the target. If the target exists, it is replaced; the file takes over the
  // target's permissions, and the target's owner if this process may set it. The file is flushed to
  // the disk (fsync) before the renaming, and the folder afterwards. Throws Error if this fails;
  // the target is then unchanged.
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

// Removes the files of all TemporaryFiles of this process. This function is async-signal-safe: it
// is called by handlers of signals that end the process. Does nothing in a forked child. If more
// than 16 such files exist at once, only 16 of them are removed.
void removeTemporaryFiles() noexcept;

}  // namespace resect
