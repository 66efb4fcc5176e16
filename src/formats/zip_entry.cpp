#include "formats/zip_entry.h"

#include "base/error.h"
#include "formats/gzip.h"
#include "formats/meshes/word_reader.h"

namespace resect {
namespace {

constexpr std::string_view kLocal = "PK\x03\x04", kCentral = "PK\x01\x02", kEnd = "PK\x05\x06";
constexpr std::size_t kEndSize = 22, kCentralSize = 46, kLocalSize = 30;
constexpr std::uint64_t kStored = 0, kDeflated = 8;

// Little-endian numbers of the archive. Reading beyond its end throws Error.
struct Archive {
  const std::string& path;
  std::string_view bytes;

  Error damaged() const {
    return error("{}: the archive is damaged or cut off; copy the file again", path);
  }
  std::string_view part(std::size_t at, std::size_t size) const {
    if (at > bytes.size() || size > bytes.size() - at) throw damaged();
    return bytes.substr(at, size);
  }
  std::size_t number(std::size_t at, int size) const {
    std::size_t value = 0;
    const std::string_view digits = part(at, std::size_t(size));
    for (int i = size; i-- > 0;) value = value << 8 | std::size_t(std::uint8_t(digits[i]));
    return value;
  }
};

std::string content(const Archive& archive, std::size_t central, std::size_t most) {
  const std::size_t method = archive.number(central + 10, 2);
  const std::size_t size = archive.number(central + 20, 4);
  const std::size_t local = archive.number(central + 42, 4);
  if (archive.part(local, kLocalSize).substr(0, 4) != kLocal) throw archive.damaged();
  const std::size_t start =
      local + kLocalSize + archive.number(local + 26, 2) + archive.number(local + 28, 2);
  const std::string_view packed = archive.part(start, size);
  if (method == kDeflated) return unpackDeflate(archive.path, packed, most);
  if (method != kStored)
    throw error("{}: is compressed by method {}, which is not read; pack it with deflate",
                archive.path, method);
  if (packed.size() > most)
    throw error("{}: unpacks to more than {} MB; simplify the model", archive.path, most >> 20);
  return std::string(packed);
}

}  // namespace

bool isZip(std::string_view bytes) { return bytes.starts_with(kLocal); }

std::optional<std::string> zipEntry(const std::string& path, std::string_view bytes,
                                    std::string_view ending, std::size_t most) {
  const Archive archive{path, bytes};
  const std::size_t end = bytes.rfind(kEnd);
  if (end == bytes.npos || bytes.size() - end < kEndSize) throw archive.damaged();
  const std::size_t entries = archive.number(end + 10, 2);
  std::size_t at = archive.number(end + 16, 4);
  for (std::size_t i = 0; i < entries; ++i) {
    if (archive.part(at, kCentralSize).substr(0, 4) != kCentral) throw archive.damaged();
    const std::size_t nameSize = archive.number(at + 28, 2);
    const std::string name = lowerCase(archive.part(at + kCentralSize, nameSize));
    if (name.ends_with(lowerCase(ending))) return content(archive, at, most);
    at += kCentralSize + nameSize + archive.number(at + 30, 2) + archive.number(at + 32, 2);
  }
  return {};
}

}  // namespace resect
