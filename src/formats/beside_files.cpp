#include "formats/beside_files.h"

#include <algorithm>
#include <array>

#include "formats/meshes/gltf_buffers.h"
#include "formats/meshes/word_reader.h"

namespace resect {
namespace {

namespace fs = std::filesystem;

template <std::size_t N>
bool endsInOne(const fs::path& name, const std::array<const char*, N>& endings) {
  return std::ranges::find(endings, lowerCase(name.extension().string())) != endings.end();
}

}  // namespace

void addFilesBeside(std::vector<fs::path>& files) {
  constexpr std::array kImageHeaders{".hdr", ".nhdr", ".mhd"};
  std::error_code ec;
  for (std::size_t i = 0, all = files.size(); i < all; ++i) {
    if (!isGltf(files[i]) && !endsInOne(files[i], kImageHeaders)) continue;
    const fs::path folder = files[i].has_parent_path() ? files[i].parent_path() : ".";
    for (const auto& entry : fs::directory_iterator(folder, ec))
      if (mayReferTo(files[i], entry.path())) files.push_back(entry.path());
  }
}

bool mayReferTo(const fs::path& path, const fs::path& name) {
  const fs::path unpacked = lowerCase(path.extension().string()) == ".gz" ? path.stem() : path;
  return isGltf(unpacked) ? isGltfBuffer(name) : isVoxelFile(name);
}

bool isVoxelFile(const fs::path& name) {
  constexpr std::array kEndings{".raw", ".zraw", ".img", ".gz"};
  return endsInOne(name, kEndings);
}

}  // namespace resect
