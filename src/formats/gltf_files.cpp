#include "formats/gltf_files.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace resect {
namespace {

namespace fs = std::filesystem;

constexpr std::array kBufferEndings{".bin", ".glbin", ".glbuf"};

std::string lowerEnding(const fs::path& name) {
  std::string ending = name.extension().string();
  for (char& c : ending) c = char(std::tolower(static_cast<unsigned char>(c)));
  return ending;
}

}  // namespace

bool isGltf(const fs::path& name) { return lowerEnding(name) == ".gltf"; }

bool isGltfBuffer(const fs::path& name) {
  return std::ranges::find(kBufferEndings, lowerEnding(name)) != kBufferEndings.end();
}

void addFilesOfGltf(std::vector<fs::path>& files) {
  std::error_code ec;
  for (std::size_t i = 0, models = files.size(); i < models; ++i) {
    if (!isGltf(files[i])) continue;
    const fs::path folder = files[i].has_parent_path() ? files[i].parent_path() : ".";
    for (const auto& entry : fs::directory_iterator(folder, ec))
      if (isGltfBuffer(entry.path())) files.push_back(entry.path());
  }
}

}  // namespace resect
