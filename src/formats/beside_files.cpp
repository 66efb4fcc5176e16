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
    const bool model = isGltf(files[i]), image = endsInOne(files[i], kImageHeaders);
    if (!model && !image) continue;
    const fs::path folder = files[i].has_parent_path() ? files[i].parent_path() : ".";
    for (const auto& entry : fs::directory_iterator(folder, ec))
      if (model ? isGltfBuffer(entry.path()) : isVoxelFile(entry.path()))
        files.push_back(entry.path());
  }
}

bool isVoxelFile(const fs::path& name) {
  constexpr std::array kEndings{".raw", ".zraw", ".img", ".gz"};
  return endsInOne(name, kEndings);
}

}  // namespace resect
