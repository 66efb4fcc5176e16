#include "io/output/output_target.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <optional>

#include "base/error.h"

namespace resect {
namespace {

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;  // as the system itself follows

// The number in /proc/self/fd/NUMBER, however the folder is called; none for other names.
std::optional<int> descriptorNamed(const fs::path& name) {
  const std::string digits = name.filename().string();
  int number = 0;
  const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (fault != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  std::error_code ec;
  const fs::path own = fs::canonical("/proc/self/fd", ec);
  if (ec || fs::canonical(name.parent_path(), ec) != own || ec) return std::nullopt;
  return number;
}

struct LinkEnd {
  fs::path path;
  std::optional<int> descriptor;
  bool viaLink = false;
};

// Follows symbolic links at the end of a name, to the descriptor or to what is no link.
LinkEnd followLinks(const fs::path& name) {
  LinkEnd at{name, {}, false};
  for (int i = 0; i < kMostLinks; ++i) {
    at.descriptor = descriptorNamed(at.path);
    std::error_code ec;
    if (at.descriptor || !fs::is_symlink(at.path, ec)) return at;
    const fs::path next = fs::read_symlink(at.path, ec);
    if (ec) throw error("cannot write {}: {}; choose another name", name.string(), ec.message());
    at.path = next.is_absolute() ? next : at.path.parent_path() / next;
    at.viaLink = true;
  }
  throw error("cannot write {}: its links lead in a circle; choose another name", name.string());
}

void requireWritableFolder(const fs::path& name, const fs::path& file) {
  std::error_code ec;
  fs::path folder = fs::absolute(file, ec).parent_path();
  while (!fs::exists(folder, ec) && folder.has_relative_path()) folder = folder.parent_path();
  if (!fs::is_directory(folder, ec))
    throw error("cannot write {}: {} is not a folder; choose another place", name.string(),
                folder.string());
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    throw error("cannot write {}: {}; choose a folder you may write to", name.string(),
                std::strerror(errno));
}

std::string identityIn(const struct stat& file) {
  return fmt::format("inode {} of device {}", file.st_ino, file.st_dev);
}

bool isNowhere(const struct stat& file) {
  struct stat nowhere {};
  return S_ISCHR(file.st_mode) && ::stat("/dev/null", &nowhere) == 0 &&
         file.st_rdev == nowhere.st_rdev;
}

}  // namespace

OutputTarget findTarget(const fs::path& name) {
  if (name.empty()) throw usageError("the name of a file to write is empty; give one");
  const LinkEnd end = followLinks(name);
  if (end.descriptor) {
    const int flags = ::fcntl(*end.descriptor, F_GETFL);
    if (flags < 0 || (flags & O_ACCMODE) == O_RDONLY)
      throw error("cannot write {}: it is not open for writing; name a file", name.string());
    return {OutputTarget::Kind::Descriptor, name, *end.descriptor};
  }
  struct stat found {};
  if (::stat(name.c_str(), &found) != 0) {
    if (errno != ENOENT && errno != ENOTDIR)
      throw error("cannot write {}: {}; choose another name", name.string(), std::strerror(errno));
    if (end.viaLink)
      throw error("cannot write {}: it is a link to {}, which does not exist; remove the link",
                  name.string(), end.path.string());
    if (!end.path.has_filename())
      throw error("cannot write {}: it is a folder; give the name of a file", name.string());
    requireWritableFolder(name, end.path);
    return {OutputTarget::Kind::File, end.path, -1};
  }
  if (S_ISDIR(found.st_mode))
    throw error("cannot write {}: it is a folder; give the name of a file", name.string());
  if (S_ISBLK(found.st_mode) || S_ISSOCK(found.st_mode))
    throw error("cannot write {}: it is a {}; give the name of a file", name.string(),
                S_ISBLK(found.st_mode) ? "disk" : "socket");
  if (!S_ISREG(found.st_mode)) {
    if (::access(name.c_str(), W_OK) != 0)
      throw error("cannot write {}: {}; name a file", name.string(), std::strerror(errno));
    return {OutputTarget::Kind::Stream, name, -1};
  }
  // The bits, since the system lets the superuser write anyway.
  if ((found.st_mode & 0222) == 0)
    throw error("cannot write {}: it is write-protected; choose another name", name.string());
  requireWritableFolder(name, end.path);
  return {OutputTarget::Kind::File, end.path, -1};
}

std::string identityOf(const fs::path& name) {
  struct stat found {};
  if (name == "-" ? ::fstat(STDOUT_FILENO, &found) == 0 : ::stat(name.c_str(), &found) == 0)
    return isNowhere(found) ? "" : identityIn(found);
  if (name == "-") return "";
  std::error_code ec;
  const fs::path whole = fs::weakly_canonical(fs::absolute(name, ec), ec);
  return ec ? name.lexically_normal().string() : whole.string();
}

bool isStandardOutput(const fs::path& name) {
  if (name == "-") return true;
  if (name.empty()) return false;
  const std::string own = identityOf("-");
  return !own.empty() && identityOf(name) == own;
}

}  // namespace resect
