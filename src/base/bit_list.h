// Which bits of a word are set? Their numbers as a list, made without a branch that depends on
// them.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace resect {

// Per byte the numbers of its set bits, ascending; then zeros.
inline constexpr auto kBitsOfByte = [] {
  std::array<std::array<std::uint8_t, 8>, 256> lists{};
  for (std::size_t byte = 0; byte < 256; ++byte)
    for (std::size_t bit = 0, n = 0; bit < 8; ++bit)
      if (byte >> bit & 1) lists[byte][n++] = std::uint8_t(bit);
  return lists;
}();

// Appends first + the number of each set bit, ascending; returns the end of the list. Writes up to
// 8 numbers more than there are. first: a multiple of 8, at most 192. Aims at seven instructions a
// byte of the word: short loops over set bits end where no processor guesses.
[[gnu::always_inline]] inline std::uint8_t* appendSetBits(std::uint64_t word, unsigned first,
                                                          std::uint8_t* list) {
#pragma GCC unroll 8
  for (unsigned byte = 0; byte < 8; ++byte) {
    const std::uint64_t bits = word >> 8 * byte & 0xff;
    std::uint64_t numbers;
    std::memcpy(&numbers, kBitsOfByte[bits].data(), sizeof numbers);
    numbers += std::uint64_t(0x0101010101010101) * (first + 8 * byte);
    std::memcpy(list, &numbers, sizeof numbers);
    list += std::popcount(bits);
  }
  return list;
}

}  // namespace resect
