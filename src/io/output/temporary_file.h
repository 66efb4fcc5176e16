// A file that is made under a temporary name beside its target and renamed when it is whole.
#pragma once

#include <filesystem>

namespace resect {

class TemporaryFile {
 public:
  // Creates an empty file in the folder of `target`, under a name that nobody can foresee and only
  // if nothing has that name: a link planted there is not followed. Throws Error if the folder
  // cannot be written.
  explicit TemporaryFile(const std::filesystem::path& target);
  // Removes the file, unless it was renamed.
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  int descriptor() const { return descriptor_; }               // open for reading and writing
  const std::filesystem::path& path() const { return path_; }  // until it is renamed

  // Puts all bytes on the disk, then the file in the target's place, with the owner and the
  // permissions of the file that was there, then the folder's new entry on the disk. Throws Error
  // if any of it fails; the file at the target is then as it was.
  void rename();
  // The same where nothing may be at the target: replaces nothing, and throws Error instead.
  void publish();

 private:
  void sync();
  void settle();

  std::filesystem::path target_, path_;
  int descriptor_ = -1;
  int slot_ = -1;  // in the list of removeTemporaryFiles()
};

// Removes every TemporaryFile of this process from its folder: for handlers of signals that end the
// process, in which it may be called. Does nothing in a forked child. Of more than 16 at once, the
// others are left.
void removeTemporaryFiles() noexcept;

}  // namespace resect
