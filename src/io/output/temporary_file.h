// A file that is written under a temporary name beside its target and renamed when it is complete.
#pragma once

#include <filesystem>

namespace resect {

class TemporaryFile {
 public:
  // Creates an empty file with a random name in the folder of `target`. If a file or link with this
  // name already exists, tries another name. Throws Error if the folder cannot be written.
  explicit TemporaryFile(const std::filesystem::path& target);
  // Removes the file, unless it was renamed.
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  int descriptor() const { return descriptor_; }               // open for reading and writing
  const std::filesystem::path& path() const { return path_; }  // valid until the file is renamed

  // Gives the file the name of the target. If the target exists, it is replaced. The file then gets
  // the permissions of the replaced file, and also its owner, if this process may set the owner.
  // The file is flushed to the disk (fsync) before it is renamed, and the folder is flushed
  // afterwards. Throws Error if the file cannot be flushed or renamed; the target is then
  // unchanged.
  void rename();
  // Does the same as rename(), but never replaces a target: throws Error if the target exists.
  void publish();

 private:
  void sync();
  void settle();

  std::filesystem::path target_, path_;
  int descriptor_ = -1;
  int slot_ = -1;  // index in the list that removeTemporaryFiles() uses
};

// Removes the files of all TemporaryFiles of this process. This function is async-signal-safe,
// since it is called by the signal handlers that end the process. Does nothing in a forked child.
// If more than 16 such files exist at once, only 16 of them are removed.
void removeTemporaryFiles() noexcept;

}  // namespace resect
