// Numbers of single precision of a grid's columns, eight at a time with AVX2.
#pragma once

#if defined(__x86_64__)
#include "collision/avx2_integers.h"

namespace resect {

// The first line at a place or beyond it.
RESECT_AVX2 inline __m256 roundedUp(__m256 v) {
  return _mm256_round_ps(v, _MM_FROUND_TO_POS_INF | _MM_FROUND_NO_EXC);
}

// Eight lanes of 32 bits, wherever.
template <typename To, typename Vector>
RESECT_AVX2 inline void put(To* to, Vector v) {
  static_assert(sizeof v == 8 * sizeof(To));
  __builtin_memcpy(to, &v, sizeof v);
}

}  // namespace resect

#endif
