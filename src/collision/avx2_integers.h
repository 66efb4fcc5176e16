// 64-bit integers of the columns' exact tests, four at a time with AVX2, and vectors put together
// and packed.
#pragma once

#if defined(__x86_64__)
#include <immintrin.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/instruction_set.h"

// Every function that gives such vectors is inlined: how they would be passed does not matter.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace resect {

// Four numbers of 64 bits, or pairs of 32, from anywhere; at(k) says where.
template <typename At>
RESECT_AVX2 inline __m256i gathered(const At& at) {
  std::int64_t four[4];
  for (std::size_t k = 0; k < 4; ++k) __builtin_memcpy(&four[k], at(k), sizeof four[k]);
  return _mm256_set_epi64x(four[3], four[2], four[1], four[0]);
}

// v, or -v where all bits of `turn` are set.
RESECT_AVX2 inline __m256i turned(__m256i v, __m256i turn) {
  return _mm256_sub_epi64(_mm256_xor_si256(v, turn), turn);
}

// Rounded once, as the processor's own conversion: both halves are exact.
RESECT_AVX2 inline __m256d toDouble(__m256i v) {
  const __m256i low = _mm256_blend_epi32(_mm256_set1_epi64x(0x4330'0000'0000'0000), v, 0x55);
  const __m256i high = _mm256_xor_si256(_mm256_srli_epi64(v, 32),
                                        _mm256_set1_epi64x(0x4530'0000'8000'0000));  // 2^84 + 2^63
  const __m256d both = _mm256_castsi256_pd(_mm256_set1_epi64x(0x4530'0000'8010'0000));  // and 2^52
  return _mm256_add_pd(_mm256_sub_pd(_mm256_castsi256_pd(high), both), _mm256_castsi256_pd(low));
}

// For each set of four lanes of 64 bits: the halves of those in it, one after the other.
inline constexpr std::array<std::array<std::int32_t, 8>, 16> kPacked = [] {
  std::array<std::array<std::int32_t, 8>, 16> orders{};
  for (unsigned set = 0; set < 16; ++set) {
    std::size_t at = 0;
    for (int lane = 0; lane < 4; ++lane)
      if (set >> lane & 1) {
        orders[set][at++] = 2 * lane;
        orders[set][at++] = 2 * lane + 1;
      }
  }
  return orders;
}();
// The lanes in the set come first.
RESECT_AVX2 inline __m256i packed(__m256i v, unsigned set) {
  return _mm256_permutevar8x32_epi32(
      v, _mm256_loadu_si256(reinterpret_cast<const __m256i*>(kPacked[set].data())));
}

// The same of eight lanes of 32 bits.
inline constexpr std::array<std::array<std::uint8_t, 8>, 256> kPackedEight = [] {
  std::array<std::array<std::uint8_t, 8>, 256> orders{};
  for (unsigned set = 0; set < 256; ++set) {
    std::size_t at = 0;
    for (unsigned lane = 0; lane < 8; ++lane)
      if (set >> lane & 1) orders[set][at++] = std::uint8_t(lane);
  }
  return orders;
}();
RESECT_AVX2 inline __m256i packedOrder(unsigned set) {
  return _mm256_cvtepu8_epi32(
      _mm_loadl_epi64(reinterpret_cast<const __m128i*>(kPackedEight[set].data())));
}
RESECT_AVX2 inline __m256i packedEight(__m256i v, unsigned set) {
  return _mm256_permutevar8x32_epi32(v, packedOrder(set));
}

// Four pairs, one after the other: 64 bytes.
RESECT_AVX2 inline void storePairs(__m256i firsts, __m256i seconds, void* to) {
  const __m256i even = _mm256_unpacklo_epi64(firsts, seconds),
                odd = _mm256_unpackhi_epi64(firsts, seconds);
  auto* out = static_cast<__m256i*>(to);
  _mm256_storeu_si256(out, _mm256_permute2x128_si256(even, odd, 0x20));
  _mm256_storeu_si256(out + 1, _mm256_permute2x128_si256(even, odd, 0x31));
}

}  // namespace resect

#endif
