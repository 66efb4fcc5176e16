#include "formats/mp4_check.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cstdint>
#include <string_view>

namespace resect {
namespace {

// Big-endian, as all numbers of the format.
std::uint64_t numberIn(const unsigned char* bytes, int count) {
  std::uint64_t number = 0;
  for (int i = 0; i < count; ++i) number = number << 8 | bytes[i];
  return number;
}

}  // namespace

bool isWholeMp4(int descriptor) {
  struct stat file {};
  if (::fstat(descriptor, &file) != 0) return false;
  const auto size = std::uint64_t(file.st_size);
  bool index = false, pictures = false;
  for (std::uint64_t at = 0; at < size;) {
    // 4 bytes of length, 4 of type; where the length is 1, it follows in 8 more.
    unsigned char header[16] = {};
    if (::pread(descriptor, header, sizeof header, off_t(at)) < 8) return false;
    const std::uint64_t brief = numberIn(header, 4);
    const std::uint64_t length = brief == 1 ? numberIn(header + 8, 8) : brief;
    if (length < (brief == 1 ? 16 : 8) || length > size - at) return false;
    const std::string_view type(reinterpret_cast<const char*>(header) + 4, 4);
    index = index || type == "moov";
    pictures = pictures || type == "mdat";
    at += length;
  }
  return index && pictures;
}

}  // namespace resect
