#include "formats/meshes/gltf_buffers.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "base/error.h"

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

std::string withoutPercents(std::string_view text) {
  const auto digit = [](char c) { return c <= '9' ? c - '0' : (c | 32) - 'a' + 10; };
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool coded = text[i] == '%' && i + 2 < text.size() &&
                       std::isxdigit(static_cast<unsigned char>(text[i + 1])) &&
                       std::isxdigit(static_cast<unsigned char>(text[i + 2]));
    plain += coded ? char(16 * digit(text[i + 1]) + digit(text[i + 2])) : text[i];
    if (coded) i += 2;
  }
  return plain;
}

void requireGltfBuffer(const std::string& path, const std::string& name) {
  if (!isGltfBuffer(name))
    throw error("{}: a buffer of it is no .bin file beside it; export it as .glb", path);
}

}  // namespace resect
