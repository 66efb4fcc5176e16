#include "io/whole_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "base/error.h"

namespace resect {
namespace {

struct Descriptor {
  int number;
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
};

}  // namespace

std::string readWholeFile(const std::filesystem::path& path, std::size_t most) {
  // Never waits: what looks like a file may be a window on the kernel.
  const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)};
  struct stat status {};
  if (file.number < 0 || ::fstat(file.number, &status) != 0 || !S_ISREG(status.st_mode))
    throw error("{} is not a file that can be read; check the name", path.string());
  const auto tooLarge = [&] {
    return error("{} has more than the {} MB that are read; check the name", path.string(),
                 most >> 20);
  };
  if (std::size_t(status.st_size) > most) throw tooLarge();
  std::string bytes;
  bytes.reserve(std::size_t(status.st_size) + 1);
  for (std::size_t got = 0;; got = bytes.size()) {
    bytes.resize(std::max(bytes.capacity(), got + (1 << 16)));
    const ssize_t count = ::read(file.number, bytes.data() + got, bytes.size() - got);
    bytes.resize(got + std::size_t(std::max<ssize_t>(count, 0)));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0)
      throw error("{} cannot be read: {}; check its permissions", path.string(),
                  std::strerror(errno));
    if (count == 0) return bytes;
    if (bytes.size() > most) throw tooLarge();
  }
}

}  // namespace resect
