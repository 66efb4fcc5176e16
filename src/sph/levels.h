// Colour values as 128ths of a full cell, a byte each.
//
// An organ from a mesh has no others: discretize() gives each cell the share of 4 x 4 x 4 samples
// inside, fitSurface() corrects these by whole levels, tools empty cells. As numbers they are
// exact: 100/128 has few digits.
#pragma once

#include <cmath>
#include <cstdint>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace resect {

constexpr float kLevel = 100.f / 128;  // the colour value of one
constexpr std::uint8_t kFullLevel = 128;

// value: in [0, 100]. False if it is not a whole number of levels.
inline bool inLevels(float value, std::uint8_t& number) {
  number = std::uint8_t(std::lround(value / kLevel));
  return float(number) * kLevel == value;
}

// Sixteen at a time. some, full: bits of those that hold anything, and all they can. False if one
// is not a whole number of them. Aims at 35 instructions.
[[gnu::always_inline]] inline bool inLevels(const float* values, std::uint8_t* numbers,
                                            std::uint64_t& some, std::uint64_t& full) {
#ifdef __SSE2__
  __m128i number[4];
  __m128 other = _mm_setzero_ps();
#pragma GCC unroll 4
  for (int k = 0; k < 4; ++k) {
    const __m128 value = _mm_loadu_ps(values + 4 * k);
    number[k] = _mm_cvtps_epi32(_mm_mul_ps(value, _mm_set1_ps(1 / kLevel)));
    const __m128 again = _mm_mul_ps(_mm_cvtepi32_ps(number[k]), _mm_set1_ps(kLevel));
    other = _mm_or_ps(other, _mm_cmpneq_ps(again, value));
  }
  const __m128i bytes = _mm_packus_epi16(_mm_packs_epi32(number[0], number[1]),
                                         _mm_packs_epi32(number[2], number[3]));
  _mm_storeu_si128(reinterpret_cast<__m128i*>(numbers), bytes);
  const auto equal = [&](std::uint8_t to) {
    const __m128i all = _mm_set1_epi8(char(to));
    return std::uint64_t(std::uint32_t(_mm_movemask_epi8(_mm_cmpeq_epi8(bytes, all))));
  };
  some = equal(0) ^ 0xffff;
  full = equal(kFullLevel);
  return _mm_movemask_ps(other) == 0;
#else
  bool all = true;
  some = full = 0;
  for (int i = 0; i < 16; ++i) {
    all = inLevels(values[i], numbers[i]) && all;
    some |= std::uint64_t(numbers[i] != 0) << i;
    full |= std::uint64_t(numbers[i] == kFullLevel) << i;
  }
  return all;
#endif
}

}  // namespace resect
