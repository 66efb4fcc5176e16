#include "io/output/temporary_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdint>
#include <cstring>

#include "base/error.h"

namespace resect {
namespace {

namespace fs = std::filesystem;

// The names to be removed, where a signal's handler can read them: no memory is allocated and no
// lock taken.
struct Slot {
  std::atomic<bool> taken{false};
  std::atomic<pid_t> owner{0};  // process that is to remove the file; 0: no name yet
  char name[PATH_MAX];
};
Slot slots[16];

// The number of the slot that keeps the name; -1 if all are taken or the name is too long for any
// file.
int keep(const std::string& name) {
  if (name.size() >= PATH_MAX) return -1;
  for (int i = 0; i < int(std::size(slots)); ++i) {
    if (slots[i].taken.exchange(true)) continue;
    std::memcpy(slots[i].name, name.c_str(), name.size() + 1);
    slots[i].owner = ::getpid();
    return i;
  }
  return -1;
}

void forget(int slot) {
  if (slot < 0) return;
  slots[slot].owner = 0;
  slots[slot].taken = false;
}

// 16 hexadecimal digits. Of the system's generator: names need not repeat from run to run.
std::string unforeseenDigits() {
  std::uint64_t bits = 0;
  if (::getentropy(&bits, sizeof bits) != 0)
    throw error("the system gives no random numbers: {}; try again", std::strerror(errno));
  return fmt::format("{:016x}", bits);
}

void syncFolder(const fs::path& folder) {
  const int opened = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (opened < 0) return;  // a folder may be written and not read
  ::fsync(opened);         // some file systems have no fsync for folders; the file itself is whole
  ::close(opened);
}

}  // namespace

TemporaryFile::TemporaryFile(const fs::path& target) : target_(target) {
  struct stat before {};
  const bool replaces = ::stat(target.c_str(), &before) == 0;
  // Until it has the permissions of the file that it replaces, nobody else may read it.
  const mode_t mode = replaces ? 0600 : 0666;
  for (int attempt = 0; attempt < 100 && descriptor_ < 0; ++attempt) {
    path_ = target.parent_path() / (".resect-" + unforeseenDigits() + ".tmp");
    // Kept before the file exists, so that no signal comes between.
    slot_ = keep(path_.string());
    descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
    if (descriptor_ >= 0) return;
    const int fault = errno;
    forget(slot_);
    slot_ = -1;
    if (fault != EEXIST && fault != EINTR)
      throw error("cannot write {}: {}; choose a folder you may write to", target.string(),
                  std::strerror(fault));
  }
  throw error("cannot write {}: every temporary name beside it is taken; choose another folder",
              target.string());
}

TemporaryFile::~TemporaryFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  ::unlink(path_.c_str());
  forget(slot_);
}

void TemporaryFile::rename() {
  struct stat before {};
  if (::stat(target_.c_str(), &before) == 0) {
    // Only the superuser can give files away; whoever may not keeps it.
    [[maybe_unused]] const int given = ::fchown(descriptor_, before.st_uid, before.st_gid);
    ::fchmod(descriptor_, before.st_mode & 0777);
  }
  sync();
  if (::rename(path_.c_str(), target_.c_str()) != 0)
    throw error("cannot write {}: {}; choose another name", target_.string(), std::strerror(errno));
  settle();
}

void TemporaryFile::publish() {
  sync();
  // A link, since a renamed file would replace what somebody put there meanwhile.
  const bool linked = ::link(path_.c_str(), target_.c_str()) == 0;
  struct stat there {};
  if (!linked && (::lstat(target_.c_str(), &there) == 0 ||  // else a file system without links
                  ::rename(path_.c_str(), target_.c_str()) != 0))
    throw error("{}: cannot be made: {}; choose another name", target_.string(),
                std::strerror(errno));
  if (linked) ::unlink(path_.c_str());
  settle();
}

void TemporaryFile::sync() {
  if (::fsync(descriptor_) != 0)
    throw error("cannot write {}: {}; free some space and try again", target_.string(),
                std::strerror(errno));
}

// It has its lasting name.
void TemporaryFile::settle() {
  ::close(descriptor_);
  descriptor_ = -1;
  forget(slot_);
  const fs::path folder = target_.parent_path();
  syncFolder(folder.empty() ? "." : folder);
}

void removeTemporaryFiles() noexcept {
  const int fault = errno;
  const pid_t self = ::getpid();
  for (Slot& slot : slots)
    if (slot.owner == self) ::unlink(slot.name);
  errno = fault;
}

}  // namespace resect
