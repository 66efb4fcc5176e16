#include "io/atomic_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "base/error.h"

namespace resect {

void writeFileAtomically(const std::filesystem::path& path,
                         const std::function<void(std::ostream&)>& write) {
  namespace fs = std::filesystem;
  std::error_code ec;
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), ec);
  const fs::path temporary = path.string() + fmt::format(".{}.tmp", ::getpid());
  try {
    std::ofstream out(temporary, std::ios::binary);
    if (!out)
      throw error("cannot write {}: {}; choose a folder you may write to", path.string(),
                  std::strerror(errno));
    write(out);
    out.close();
    if (!out)
      throw error("cannot write {}: {}; free some space and try again", path.string(),
                  std::strerror(errno));
    fs::rename(temporary, path, ec);
    if (ec) throw error("cannot write {}: {}; choose another name", path.string(), ec.message());
  } catch (...) {
    fs::remove(temporary, ec);
    throw;
  }
}

}  // namespace resect
