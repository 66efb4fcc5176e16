// Which bits of a word are set? Their numbers as a list, made without a branch that depends on
// them where they are few.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

namespace resect {

// Appends first + the number of each set bit, ascending; returns the end of the list. Writes up to
// 8 numbers more than there are. first: at most 192. Aims at four instructions a number, eight at a
// time: short loops over set bits end where no processor guesses.
[[gnu::always_inline]] inline std::uint8_t* appendSetBits(std::uint64_t word, unsigned first,
                                                          std::uint8_t* list) {
  std::uint8_t* const end = list + std::popcount(word);
  do {
    std::uint64_t numbers = 0;
#pragma GCC unroll 8
    for (unsigned k = 0; k < 8; ++k) {
      numbers |= std::uint64_t(std::countr_zero(word)) << 8 * k;
      word &= word - 1;
    }
    numbers += std::uint64_t(0x0101010101010101) * first;
    std::memcpy(list, &numbers, sizeof numbers);
    list += 8;
  } while (word != 0);
  return end;
}

}  // namespace resect
