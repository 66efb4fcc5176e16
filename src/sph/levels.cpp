#include "sph/levels.h"

#include <algorithm>

#include "base/instruction_set.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace resect {
namespace {

constexpr std::size_t kWord = 64;  // values that are taken at once
// Values that are fetched ahead where there are many: a large organ's come from memory, and a
// processor does not fetch beyond a page of its own accord.
constexpr std::size_t kAhead = 2048;
constexpr std::size_t kLine = 16;  // values of a cache line

// One word of them.
struct Told {
  std::uint64_t some = 0, full = 0;
  bool allLevels = true;
};

Told takePlainly(const float* values, std::uint8_t* levels) {
  Told told;
  for (std::size_t i = 0; i < kWord; ++i) {
    told.allLevels = toLevel(values[i], levels[i]) && told.allLevels;
    told.some |= std::uint64_t(levels[i] != 0) << i;
    told.full |= std::uint64_t(levels[i] == kFullLevel) << i;
  }
  return told;
}

template <typename Take>
[[gnu::always_inline]] inline bool takeAll(const float* values, std::size_t count,
                                           std::uint8_t* levels, std::uint64_t* some,
                                           std::uint64_t* full, Take take) {
  bool all = true;
  const auto add = [&](const float* from, std::size_t first) __attribute__((always_inline)) {
    const Told told = take(from, levels + first);
    some[first / kWord] = told.some;
    full[first / kWord] = told.full;
    all = all && told.allLevels;
  };
  std::size_t i = 0;
  for (; i + kWord <= count; i += kWord) {
    if (count > kAhead)
      for (std::size_t line = 0; line < kWord; line += kLine)
        __builtin_prefetch(values + i + kAhead + line);
    add(values + i, i);
  }
  if (i == count) return all;
  float last[kWord] = {};
  std::copy(values + i, values + count, last);
  add(last, i);
  return all;
}

#if defined(__x86_64__)

// Bit i: is byte i what all bytes of `to` are?
RESECT_AVX2 inline std::uint64_t equal(__m256i bytes, __m256i to) {
  return std::uint32_t(_mm256_movemask_epi8(_mm256_cmpeq_epi8(bytes, to)));
}

// Aims at two instructions a value.
RESECT_AVX2 inline Told takeWide(const float* values, std::uint8_t* levels) {
  Told told;
  __m256 other = _mm256_setzero_ps();
#pragma GCC unroll 2
  for (int half = 0; half < 2; ++half) {
    __m256i number[4];
#pragma GCC unroll 4
    for (int k = 0; k < 4; ++k) {
      const __m256 value = _mm256_loadu_ps(values + 32 * half + 8 * k);
      number[k] = _mm256_cvtps_epi32(_mm256_mul_ps(value, _mm256_set1_ps(1 / kLevel)));
      const __m256 again = _mm256_mul_ps(_mm256_cvtepi32_ps(number[k]), _mm256_set1_ps(kLevel));
      other = _mm256_or_ps(other, _mm256_cmp_ps(again, value, _CMP_NEQ_UQ));
    }
    // Packing goes within halves of a vector: the eighths come in order at last.
    const __m256i bytes =
        _mm256_permutevar8x32_epi32(_mm256_packus_epi16(_mm256_packs_epi32(number[0], number[1]),
                                                        _mm256_packs_epi32(number[2], number[3])),
                                    _mm256_setr_epi32(0, 4, 1, 5, 2, 6, 3, 7));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(levels + 32 * half), bytes);
    const std::uint64_t none = equal(bytes, _mm256_setzero_si256());
    told.some |= (none ^ 0xffffffff) << 32 * half;
    told.full |= equal(bytes, _mm256_set1_epi8(char(kFullLevel))) << 32 * half;
  }
  told.allLevels = _mm256_movemask_ps(other) == 0;
  return told;
}

RESECT_AVX2 bool takeAllWide(const float* values, std::size_t count, std::uint8_t* levels,
                             std::uint64_t* some, std::uint64_t* full) {
  return takeAll(values, count, levels, some, full,
                 [](const float* from, std::uint8_t* to)
                     RESECT_AVX2 { return takeWide(from, to); });
}

#endif

}  // namespace

bool toLevels(const float* values, std::size_t count, std::uint8_t* levels, std::uint64_t* some,
              std::uint64_t* full) {
#if defined(__x86_64__)
  static const bool wide = __builtin_cpu_supports("avx2");
  if (wide) return takeAllWide(values, count, levels, some, full);
#endif
  return toLevelsPlainly(values, count, levels, some, full);
}

bool toLevelsPlainly(const float* values, std::size_t count, std::uint8_t* levels,
                     std::uint64_t* some, std::uint64_t* full) {
  return takeAll(values, count, levels, some, full, takePlainly);
}

}  // namespace resect
