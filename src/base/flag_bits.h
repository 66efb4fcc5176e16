// Vectorised comparisons of the numbers or bytes of an array. The result is a word; its bit i tells
// the outcome for element i.
#pragma once

#include <cstdint>
#include <cstring>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace resect {

#ifdef __SSE2__

// compared16() passes four consecutive numbers at a time to its test. The test returns one lane per
// number: all bits of the lane are set if the comparison is true, and no bit is set if the
// comparison is false.
typedef float FourValues __attribute__((vector_size(16)));
typedef std::int32_t FourFlags __attribute__((vector_size(16)));

// Bit i of the result is set if the test is true for values[i], i from 0 to 15. test: a comparison
// (FourValues) -> FourFlags. The function can compile to 12 instructions.
template <typename Test>
[[gnu::always_inline]] inline std::uint64_t compared16(const float* values, Test test) {
  __m128i four[4];
#pragma GCC unroll 4
  for (int k = 0; k < 4; ++k) {
    FourValues v;
    std::memcpy(&v, values + 4 * k, sizeof v);
    const FourFlags flags = test(v);
    std::memcpy(&four[k], &flags, sizeof flags);
  }
  const __m128i bytes =
      _mm_packs_epi16(_mm_packs_epi32(four[0], four[1]), _mm_packs_epi32(four[2], four[3]));
  return std::uint32_t(_mm_movemask_epi8(bytes));
}

#else

// Without SSE2 the test gets one number at a time.
typedef float FourValues;
typedef bool FourFlags;

template <typename Test>
inline std::uint64_t compared16(const float* values, Test test) {
  std::uint64_t bits = 0;
  for (int i = 0; i < 16; ++i) bits |= std::uint64_t(test(values[i])) << i;
  return bits;
}

#endif

// Does the same as compared16(), but for 64 values.
template <typename Test>
[[gnu::always_inline]] inline std::uint64_t compared64(const float* values, Test test) {
  return compared16(values, test) | compared16(values + 16, test) << 16 |
         compared16(values + 32, test) << 32 | compared16(values + 48, test) << 48;
}

// nonZero64() and upperBits64() take 64 bytes. Bit i of nonZero64() is set if byte i is not 0. Bit
// i of upperBits64() is the top bit of byte i.
#ifdef __SSE2__

template <typename Test>
[[gnu::always_inline]] inline std::uint64_t ofBytes64(const std::uint8_t* bytes, Test test) {
  std::uint64_t bits = 0;
  for (int k = 0; k < 4; ++k) {
    const __m128i v = _mm_loadu_si128(reinterpret_cast<const __m128i*>(bytes + 16 * k));
    bits |= std::uint64_t(std::uint32_t(_mm_movemask_epi8(test(v)))) << 16 * k;
  }
  return bits;
}
[[gnu::always_inline]] inline std::uint64_t nonZero64(const std::uint8_t* bytes) {
  return ~ofBytes64(bytes, [](__m128i v) { return _mm_cmpeq_epi8(v, _mm_setzero_si128()); });
}
[[gnu::always_inline]] inline std::uint64_t upperBits64(const std::uint8_t* bytes) {
  return ofBytes64(bytes, [](__m128i v) { return v; });
}

#else

inline std::uint64_t nonZero64(const std::uint8_t* bytes) {
  std::uint64_t bits = 0;
  for (int i = 0; i < 64; ++i) bits |= std::uint64_t(bytes[i] != 0) << i;
  return bits;
}
inline std::uint64_t upperBits64(const std::uint8_t* bytes) {
  std::uint64_t bits = 0;
  for (int i = 0; i < 64; ++i) bits |= std::uint64_t(bytes[i] >> 7) << i;
  return bits;
}

#endif

}  // namespace resect
