#include "formats/child/foreign_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "base/error.h"
#include "base/large_pages.h"

namespace resect {
namespace {

namespace fs = std::filesystem;

class Descriptor {
 public:
  Descriptor(const fs::path& path, int flags)
      : number_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY | flags)) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

// `name`: for messages.
RawArray<char> readFile(const fs::path& path, const std::string& name, int flags,
                        std::size_t most) {
  const Descriptor file(path, flags);
  if (file.number() < 0)
    throw error("{}: cannot be opened: {}; check who may read it", name, std::strerror(errno));
  struct stat status {};
  if (::fstat(file.number(), &status) != 0 || !S_ISREG(status.st_mode))
    throw error("{}: is no ordinary file; copy its content into one", name);
  const auto size = std::size_t(status.st_size);
  if (size > most)
    throw error("{}: has {} MB, more than the {} MB that are read; make it smaller", name,
                size >> 20, most >> 20);
  RawArray<char> bytes;
  bytes.reserve(size);
  wantLargePages(bytes.data(), size);
  bytes.resize(size);
  for (std::size_t at = 0; at < size;) {
    const ssize_t got = ::read(file.number(), bytes.data() + at, size - at);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0)
      throw error("{}: cannot be read: {}; check the disk", name,
                  got < 0 ? std::strerror(errno) : "it became shorter meanwhile");
    at += std::size_t(got);
  }
  return bytes;
}

}  // namespace

RawArray<char> readForeignFile(const fs::path& path, std::size_t most, Links links) {
  std::error_code ec;
  const fs::file_status status =
      links == Links::Followed ? fs::status(path, ec) : fs::symlink_status(path, ec);
  if (!fs::exists(status)) throw error("{}: there is no such file; check the name", path.string());
  if (fs::is_directory(status)) throw error("{}: is a folder; name a file in it", path.string());
  if (!fs::is_regular_file(status))
    throw error("{}: is no ordinary file; copy its content into one", path.string());
  return readFile(path, path.string(), links == Links::Followed ? 0 : O_NOFOLLOW, most);
}

RawArray<char> readForeignFileBeside(const fs::path& path, const std::string& name,
                                     std::size_t most) {
  const auto notInName = [](unsigned char c) { return c < ' ' || c == '/' || c == 0x7f; };
  if (name.empty() || name.starts_with('.') || std::ranges::any_of(name, notInName))
    throw error(
        "{}: refers to a file that is not beside it; put all in one folder, or export it as one "
        "file",
        path.string());
  const fs::path beside = path.parent_path() / name;
  std::error_code ec;
  const fs::file_status status = fs::symlink_status(beside, ec);
  if (!fs::exists(status))
    throw error("{}: refers to the file '{}', which is not there; copy it beside the model",
                path.string(), name);
  if (!fs::is_regular_file(status))
    throw error("{}: refers to '{}', which is no ordinary file; copy the file itself there",
                path.string(), name);
  return readFile(beside, beside.string(), O_NOFOLLOW, most);
}

}  // namespace resect
