// Lists the indices of the set bits of a 64-bit word. The code branches only once for every eight
// indices, which avoids mispredicted branches if few bits are set.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

namespace resect {

// For each set bit, writes the sum of `first` and the bit's index to `list`, in ascending order.
// Returns the end of these numbers in `list`. The function may overwrite up to 8 elements beyond
// this end. first: at most 192, so that each sum fits into 8 bits.
//
// The function always writes eight indices at a time.
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
