#include "io/whole_file.h"

#include <fstream>
#include <iterator>

#include "base/error.h"

namespace resect {

std::string readWholeFile(const std::filesystem::path& path) {
  std::error_code fault;
  if (!std::filesystem::is_regular_file(path, fault))
    throw error("{} is not a file that can be read; check the name", path.string());
  std::ifstream in(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (!in.good() && !in.eof())
    throw error("{} cannot be read; check its permissions", path.string());
  return bytes;
}

}  // namespace resect
