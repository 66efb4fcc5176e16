#include "io/output/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "base/error.h"
#include "io/output/descriptor_buffer.h"
#include "io/output/output_target.h"
#include "io/output/temporary_file.h"

namespace resect {
namespace {

using Write = std::function<void(std::ostream&)>;

// Throws Error unless all that `write` writes has got into the descriptor.
void writeInto(int descriptor, const std::filesystem::path& path, const Write& write) {
  DescriptorBuffer buffer(descriptor);
  std::ostream out(&buffer);
  write(out);
  const int finished = buffer.finish();
  if (const int fault = finished == 0 && !out ? EIO : finished; fault != 0)
    throw error("cannot write {}: {}; {}", path.string(), std::strerror(fault),
                fault == EPIPE ? "its reader has ended"
                : fault == ENOSPC || fault == EDQUOT || fault == EFBIG
                    ? "free some space and try again"
                    : "choose another name");
}

void writeStream(const std::filesystem::path& path, const Write& write) {
  const int opened = ::open(path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
  if (opened < 0)
    throw error("cannot write {}: {}; name a file", path.string(), std::strerror(errno));
  try {
    writeInto(opened, path, write);
  } catch (...) {
    ::close(opened);
    throw;
  }
  ::close(opened);
}

}  // namespace

void writeFileAtomically(const std::filesystem::path& path, const Write& write) {
  const OutputTarget target = findTarget(path);
  if (target.kind == OutputTarget::Kind::Descriptor) {
    std::fflush(nullptr);  // what was printed before comes before
    return writeInto(target.descriptor, path, write);
  }
  if (target.kind == OutputTarget::Kind::Stream) return writeStream(path, write);
  std::error_code ec;  // that a folder is missing is said when the file is created
  if (target.path.has_parent_path())
    std::filesystem::create_directories(target.path.parent_path(), ec);
  TemporaryFile file(target.path);
  writeInto(file.descriptor(), path, write);
  file.rename();
}

}  // namespace resect
