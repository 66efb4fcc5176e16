#include "collision/lone_points.h"

#if defined(__x86_64__)
#include <algorithm>
#include <bit>

#include "collision/avx2_floats.h"

namespace resect {
namespace {

RESECT_AVX2 inline __m256 least(__m256 a, __m256 b, __m256 c) {
  return _mm256_min_ps(_mm256_min_ps(a, b), c);
}
RESECT_AVX2 inline __m256 most(__m256 a, __m256 b, __m256 c) {
  return _mm256_max_ps(_mm256_max_ps(a, b), c);
}

// An edge function of points that are wrong by `slack`, less than a column and a row away, is wrong
// by 4 slack + 2 slack^2 and by seven roundings of what is at most 1.
float doubtOf(const RoughMesh& mesh) { return 4.5f * mesh.slack + 0x1p-21f; }

// A corner of eight triangles.
struct Eight {
  __m256 column, row;
};
RESECT_AVX2 inline Eight cornersOf(const RoughPoint* points, const Triangle* t,
                                   std::size_t corner) {
  const auto two = [&](std::size_t i, std::size_t j) RESECT_AVX2 {
    double first, second;
    __builtin_memcpy(&first, points + t[i][corner], sizeof first);
    __builtin_memcpy(&second, points + t[j][corner], sizeof second);
    return _mm_setr_pd(first, second);
  };
  const __m256 even = _mm256_castpd_ps(_mm256_set_m128d(two(4, 5), two(0, 1))),
               odd = _mm256_castpd_ps(_mm256_set_m128d(two(6, 7), two(2, 3)));
  return {_mm256_shuffle_ps(even, odd, 0x88), _mm256_shuffle_ps(even, odd, 0xdd)};
}

RESECT_AVX2_FMA inline __m256 cross(const Eight& a, const Eight& b) {
  return _mm256_fmsub_ps(a.column, b.row, _mm256_mul_ps(a.row, b.column));
}
RESECT_AVX2 inline __m256 beyond(__m256 a, __m256 b) { return _mm256_cmp_ps(a, b, _CMP_GT_OQ); }
RESECT_AVX2 inline unsigned setOf(__m256 v) { return unsigned(_mm256_movemask_ps(v)); }

}  // namespace

// Aims at 18 instructions a triangle, seven of them for its corners.
RESECT_AVX2_FMA void sortOutRoughly(const RoughMesh& mesh, std::size_t begin, std::size_t end,
                                    SortedRun& run) {
  const __m256 zero = _mm256_setzero_ps(), one = _mm256_set1_ps(1);
  const __m256 columns = _mm256_set1_ps(float(mesh.columns.count)),
               rows = _mm256_set1_ps(float(mesh.rows.count));
  const __m256 doubt = _mm256_set1_ps(doubtOf(mesh)), minusDoubt = _mm256_sub_ps(zero, doubt);
  std::size_t lone = 0, unsure = 0, others = 0;
  Triangle rest[8];
  for (std::size_t t = begin; t < end; t += 8) {
    const Triangle* triangles = &mesh.mesh.triangles[t];
    unsigned all = 0xff;
    if (t + 8 > end) [[unlikely]] {
      std::fill(std::copy(triangles, triangles + (end - t), rest), rest + 8, *triangles);
      triangles = rest;
      all >>= t + 8 - end;
    }
    Eight a = cornersOf(mesh.points.get(), triangles, 0),
          b = cornersOf(mesh.points.get(), triangles, 1),
          c = cornersOf(mesh.points.get(), triangles, 2);
    const __m256 left = roundedUp(least(a.column, b.column, c.column)),
                 right = roundedUp(most(a.column, b.column, c.column)),
                 bottom = roundedUp(least(a.row, b.row, c.row)),
                 top = roundedUp(most(a.row, b.row, c.row));
    const __m256 across = _mm256_sub_ps(_mm256_min_ps(right, columns), _mm256_max_ps(left, zero)),
                 along = _mm256_sub_ps(_mm256_min_ps(top, rows), _mm256_max_ps(bottom, zero));
    const unsigned some = setOf(beyond(_mm256_min_ps(across, along), zero)) & all,
                   many = setOf(beyond(
                       _mm256_max_ps(_mm256_sub_ps(right, left), _mm256_sub_ps(top, bottom)), one));

    for (Eight* corner : {&a, &b, &c}) {
      corner->column = _mm256_sub_ps(corner->column, left);
      corner->row = _mm256_sub_ps(corner->row, bottom);
    }
    const __m256 v0 = cross(b, c), v1 = cross(c, a), v2 = cross(a, b);
    const __m256 low = least(v0, v1, v2), high = most(v0, v1, v2);
    const unsigned covered = setOf(_mm256_or_ps(beyond(low, doubt), beyond(minusDoubt, high))),
                   beside = setOf(_mm256_and_ps(beyond(minusDoubt, low), beyond(high, doubt)));
    const __m256i number = _mm256_add_epi32(_mm256_set1_epi32(std::int32_t(t)),
                                            _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
    const unsigned larger = some & many;
    put(run.larger + others, packedEight(number, larger));
    others += std::size_t(std::popcount(larger));
    const unsigned single = some & ~many, sure = single & covered;
    const __m256i order = packedOrder(sure);
    const auto putSure = [&](auto* to, __m256 v)
                             RESECT_AVX2 { put(to, _mm256_permutevar8x32_ps(v, order)); };
    putSure(run.triangle + lone, _mm256_castsi256_ps(number));
    putSure(run.column + lone, _mm256_castsi256_ps(_mm256_cvtps_epi32(left)));
    putSure(run.row + lone, _mm256_castsi256_ps(_mm256_cvtps_epi32(bottom)));
    putSure(run.v1 + lone, v1);
    putSure(run.v2 + lone, v2);
    putSure(run.perArea + lone, _mm256_div_ps(one, _mm256_add_ps(_mm256_add_ps(v0, v1), v2)));
    lone += std::size_t(std::popcount(sure));
    if (const unsigned open = single & ~(covered | beside); open != 0) [[unlikely]] {
      put(run.doubtful + unsure, packedEight(number, open));
      unsure += std::size_t(std::popcount(open));
    }
  }
  run.lone = lone;
  run.unsure = unsure;
  run.others = others;
}

// How much may a depth be wrong? The weight of corner 1 is w = v1 / area; as worked out it is
// w' = v1' / area'. With w' - w = ((v1' - v1) - w (area' - area)) / area', v1' wrong by `doubt`,
// the area by three of it and w at most 1, that is 4 doubt / area', and four roundings. Aims at 16
// instructions a triangle.
RESECT_AVX2_FMA void findSteps(const RoughMesh& mesh, const SampleLine& line, double lineSlack,
                               const SortedRun& run, Step* steps) {
  const __m256d perPitch = _mm256_set1_pd(1 / line.pitch), first = _mm256_set1_pd(line.first),
                one = _mm256_set1_pd(1), half = _mm256_set1_pd(0.5), noSign = _mm256_set1_pd(-0.0);
  const __m256d fourDoubts = _mm256_set1_pd(4 * double(doubtOf(mesh))),
                roundings = _mm256_set1_pd(0x1p-21), deep = _mm256_set1_pd(1e-14),
                slacks = _mm256_set1_pd(lineSlack);
  const __m256d behind = _mm256_set1_pd(line.count + 0.5);
  const auto size = [&](__m256d v) RESECT_AVX2 { return _mm256_andnot_pd(noSign, v); };
  const Triangle* corners[4];
  for (std::size_t k = 0; k < run.lone; k += 4) {
    for (std::size_t i = 0; i < 4; ++i)
      corners[i] = &mesh.mesh.triangles[std::size_t(run.triangle[std::min(k + i, run.lone - 1)])];
    const auto depth = [&](std::size_t corner) RESECT_AVX2 {
      const auto at = [&](std::size_t i) {
        return &mesh.mesh.points[std::size_t((*corners[i])[corner])].z();
      };
      return _mm256_set_m128d(_mm_loadh_pd(_mm_load_sd(at(2)), at(3)),
                              _mm_loadh_pd(_mm_load_sd(at(0)), at(1)));
    };
    const __m256d z0 = depth(0), dz1 = _mm256_sub_pd(depth(1), z0),
                  dz2 = _mm256_sub_pd(depth(2), z0);
    const __m128 perArea = _mm_loadu_ps(run.perArea + k);
    const auto weight = [&](const float* v) RESECT_AVX2 {
      return _mm256_cvtps_pd(_mm_mul_ps(_mm_loadu_ps(v + k), perArea));
    };
    const __m256d z =
        _mm256_fmadd_pd(weight(run.v1), dz1, _mm256_fmadd_pd(weight(run.v2), dz2, z0));
    const __m256d place = _mm256_fmadd_pd(_mm256_sub_pd(z, first), perPitch, one);
    const __m256d p = _mm256_min_pd(_mm256_max_pd(place, half), behind);
    const __m256d rise = _mm256_add_pd(size(dz1), size(dz2));
    const __m256d wrong = _mm256_fmadd_pd(size(_mm256_cvtps_pd(perArea)), fourDoubts, roundings);
    const __m256d slack = _mm256_fmadd_pd(
        _mm256_fmadd_pd(wrong, rise, _mm256_mul_pd(_mm256_add_pd(rise, size(z0)), deep)), perPitch,
        slacks);
    const __m128i point = _mm256_cvttpd_epi32(p);
    const __m256d fraction = _mm256_sub_pd(p, _mm256_cvtepi32_pd(point));
    // Nearer to a whole number than slack, or not a number.
    const __m256d near =
        _mm256_cmp_pd(size(_mm256_sub_pd(fraction, half)), _mm256_sub_pd(half, slack), _CMP_NLT_UQ);
    const __m128i leaves =
        _mm_andnot_si128(_mm_srai_epi32(_mm_castps_si128(perArea), 31), _mm_set1_epi32(1));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(steps + k),
                     _mm_or_si128(_mm_slli_epi32(point, 1), leaves));
    for (unsigned open = unsigned(_mm256_movemask_pd(near)); open != 0; open &= open - 1)
      steps[k + std::size_t(std::countr_zero(open))] = kNoStep;
  }
}

}  // namespace resect

#endif
