// 64 comparisons as the bits of one word.
#pragma once

#include <cstdint>
#include <cstring>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace resect {

// flags: 64 bytes, each 0 or 255. Bit i of the result tells of flags[i].
[[gnu::always_inline]] inline std::uint64_t flagBits(const std::uint8_t* flags) {
  std::uint64_t bits = 0;
#ifdef __SSE2__
  for (int i = 0; i < 4; ++i) {
    const __m128i sixteen = _mm_loadu_si128(reinterpret_cast<const __m128i*>(flags + 16 * i));
    bits |= std::uint64_t(std::uint32_t(_mm_movemask_epi8(sixteen))) << 16 * i;
  }
#else
  for (int i = 0; i < 64; ++i) bits |= std::uint64_t(flags[i] & 1) << i;
#endif
  return bits;
}

}  // namespace resect
