#include "io/data_folder.h"

#include <algorithm>
#include <cstdlib>

#include "base/error.h"

namespace resect {
namespace fs = std::filesystem;

fs::path dataFolder() {
  if (const char* named = std::getenv("RESECT_DATA")) {
    if (fs::is_directory(fs::path(named) / "scenarios")) return named;
    throw error(
        "RESECT_DATA is {}, but there is no folder \"scenarios\" in it; set it to Resect's data "
        "folder",
        named);
  }
  std::error_code ec;
  const fs::path program = fs::read_symlink("/proc/self/exe", ec).parent_path();
  for (const fs::path& place : {program / "../share/resect", program / "../../data",
                                fs::path(RESECT_DATA_DIR), fs::path(RESECT_INSTALLED_DATA)})
    if (fs::is_directory(place / "scenarios", ec)) return fs::weakly_canonical(place, ec);
  throw error(
      "the data folder of Resect is neither beside {} nor at {} nor at {}; set RESECT_DATA to it",
      program.string(), RESECT_DATA_DIR, RESECT_INSTALLED_DATA);
}

fs::path findDataFile(const std::string& name, const std::string& folder,
                      const std::string& extension) {
  std::error_code ec;
  if (fs::is_regular_file(name, ec)) return name;
  const bool plain = name.find('/') == std::string::npos;
  if (plain) {
    fs::path shipped = dataFolder() / folder / (name + extension);
    if (fs::is_regular_file(shipped, ec)) return shipped;
  }
  std::string known;
  for (const std::string& other : shippedNames(folder, extension))
    known += (known.empty() ? "" : ", ") + other;
  throw error("there is no file {}{}; the ones that come with Resect are: {}", name,
              plain ? " and nothing of that name comes with Resect" : "", known);
}

std::vector<std::string> shippedNames(const std::string& folder, const std::string& extension) {
  std::vector<std::string> names;
  std::error_code ec;
  for (const auto& entry : fs::directory_iterator(dataFolder() / folder, ec))
    if (entry.path().extension() == extension) names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace resect
