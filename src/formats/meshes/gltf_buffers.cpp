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
