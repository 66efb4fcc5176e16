// Numbers as the bytes of binary files.
#pragma once

#include <cstdint>
#include <string>

namespace resect::test {

// The lowest `size` bytes of a number, the lowest first; size: at most 8.
inline std::string numberBytes(std::int64_t value, int size) {
  std::string bytes;
  for (int i = 0; i < size; ++i) bytes += char(value >> (8 * i));
  return bytes;
}

}  // namespace resect::test
