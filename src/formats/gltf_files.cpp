#include "formats/gltf_files.h"

#include <algorithm>
#include <array>

namespace resect {
namespace {

namespace fs = std::filesystem;

// Endings of the files that a reader may be given beside a .gltf (formats/assimp_file.cpp).
constexpr std::array kBufferEndings{".bin", ".glbin", ".glbuf"};

}  // namespace

void addFilesOfGltf(std::vector<fs::path>& files) {
  std::error_code ec;
  for (std::size_t i = 0, models = files.size(); i < models; ++i) {
    if (files[i].extension() != ".gltf") continue;
    const fs::path folder = files[i].has_parent_path() ? files[i].parent_path() : ".";
    for (const auto& entry : fs::directory_iterator(folder, ec))
      if (std::ranges::find(kBufferEndings, entry.path().extension()) != kBufferEndings.end())
        files.push_back(entry.path());
  }
}

}  // namespace resect
