#include "io/atomic_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "base/error.h"

namespace resect {
namespace {

// Whether all write permissions are off. Reads the permission bits, since the system lets the
// superuser write anyway.
bool writeProtected(const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  constexpr fs::perms kWrite =
      fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
  std::error_code ec;
  return (fs::status(path, ec).permissions() & kWrite) == fs::perms::none;
}

}  // namespace

void checkTarget(const std::filesystem::path& path, std::span<const std::string> inputs) {
  namespace fs = std::filesystem;
  std::error_code ec;
  for (const std::string& input : inputs)
    if (fs::equivalent(path, input, ec))
      throw usageError("{} is read and would be overwritten; choose another name to write to",
                       path.string());
  if (fs::is_directory(path, ec))
    throw error("cannot write {}: it is a folder; give the name of a file", path.string());
  if (fs::is_regular_file(path, ec) && writeProtected(path))
    throw error("cannot write {}: it is write-protected; choose another name", path.string());
  fs::path folder = fs::absolute(path, ec).parent_path();
  while (!fs::exists(folder, ec) && folder.has_relative_path()) folder = folder.parent_path();
  if (!fs::is_directory(folder, ec))
    throw error("cannot write {}: {} is not a folder; choose another place", path.string(),
                folder.string());
  if (::access(folder.c_str(), W_OK) != 0)
    throw error("cannot write {}: {}; choose a folder you may write to", path.string(),
                std::strerror(errno));
}

void writeFileAtomically(const std::filesystem::path& path,
                         const std::function<void(std::ostream&)>& write) {
  namespace fs = std::filesystem;
  std::error_code ec;
  checkTarget(path);
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
