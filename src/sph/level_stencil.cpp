// Sums of a brick from cells stored as levels. With one or two nodes a cell and AVX2 mirrored cells
// are added as 16-bit integers; otherwise levels are converted to colour values and summed like
// floats.
//
// Both ways give the same bits: sums of levels have so few digits that they are exact as floats
// too.
#include "base/instruction_set.h"
#include "sph/colour_values.h"
#include "sph/field_stencil.h"
#include "sph/mirrored_sums.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

// All functions that return such vectors are inlined, so the calling convention does not matter.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace resect {
namespace {

using Level = std::uint8_t;

// Most cells in reach of a brick along an axis; cells of a row that are read.
constexpr int kWindow = 6, kWindowRow = 8;
int sideOf(const FieldStencil& stencil) { return stencil.refine == 1 ? kWindow : kWindow - 1; }

// The cells round a brick as colour values.
void widenPlainly(const Level* low, std::ptrdiff_t alongY, std::ptrdiff_t alongZ, int side,
                  float* window) {
  for (int z = 0; z < side; ++z)
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < kWindowRow; ++x)
        window[(z * kWindow + y) * kWindowRow + x] =
            float(low[z * alongZ + y * alongY + x]) * kLevel;
}

#if defined(__x86_64__)

RESECT_AVX2 void widenRows(const Level* low, std::ptrdiff_t alongY, std::ptrdiff_t alongZ, int side,
                           float* window) {
  const __m256 unit = _mm256_set1_ps(kLevel);
  for (int z = 0; z < side; ++z)
#pragma GCC unroll 6
    for (int y = 0; y < side; ++y) {
      const auto* row = reinterpret_cast<const __m128i*>(low + z * alongZ + y * alongY);
      const __m256 cells = _mm256_cvtepi32_ps(_mm256_cvtepu8_epi32(_mm_loadl_epi64(row)));
      _mm256_store_ps(window + (z * kWindow + y) * kWindowRow, _mm256_mul_ps(cells, unit));
    }
}

RESECT_AVX2 inline __m128i rowAt(const Level* from) {
  return _mm_loadu_si128(reinterpret_cast<const __m128i*>(from));
}
// Two rows of cells, arranged for four nodes each: each half of the vector holds eight sums along
// x, 16 bits each, of the pairs of cells given by `pairs`; -1: none.
RESECT_AVX2 inline __m256i alongX(__m128i first, __m128i second, __m128i pairs) {
  const __m256i cells = _mm256_inserti128_si256(_mm256_castsi128_si256(first), second, 1);
  return _mm256_maddubs_epi16(_mm256_shuffle_epi8(cells, _mm256_broadcastsi128_si256(pairs)),
                              _mm256_set1_epi8(1));
}

RESECT_AVX2 inline __m256 colour(__m256i levels) {
  return _mm256_mul_ps(_mm256_cvtepi32_ps(levels), _mm256_set1_ps(kLevel));
}

// ---- one node a cell ----

// For each of the 16 nodes of a plane, from a plane of cells: its own cell, the sum of the four
// face neighbours, the sum of the four diagonal ones. 16 bits each.
struct PlaneSums {
  __m256i own, beside, across;
};

// Two rows of cells, two apart: for each the four nodes' own cells, then the sums of the two
// neighbours along x.
RESECT_AVX2 inline __m256i twoRows(const Level* row, std::ptrdiff_t alongY) {
  return alongX(rowAt(row), rowAt(row + 2 * alongY),
                _mm_setr_epi8(1, -1, 2, -1, 3, -1, 4, -1, 0, 2, 1, 3, 2, 4, 3, 5));
}

RESECT_AVX2 inline PlaneSums planeSums(const Level* plane, std::ptrdiff_t alongY) {
  // Rows 0 and 2 of the nodes use the rows of cells 0 to 2 and 2 to 4, rows 1 and 3 those one
  // further.
  const __m256i first = twoRows(plane, alongY), second = twoRows(plane + alongY, alongY),
                third = twoRows(plane + 2 * alongY, alongY),
                fourth = twoRows(plane + 3 * alongY, alongY);
  const __m256i even = _mm256_add_epi16(first, third), odd = _mm256_add_epi16(second, fourth);
  return {_mm256_unpacklo_epi64(second, third),
          _mm256_add_epi16(_mm256_unpackhi_epi64(second, third), _mm256_unpacklo_epi64(even, odd)),
          _mm256_unpackhi_epi64(even, odd)};
}

// Mirrored sums as in sumOnCells() of field_stencil.cpp. Aims at 6 instructions a node.
RESECT_AVX2 void sumLevels(const FieldStencil& stencil, const Level* low, std::ptrdiff_t alongY,
                           std::ptrdiff_t alongZ, unsigned planes, float* out) {
  const auto& numbers = stencil.mirrored[0][0];
  const __m256 ofOwn = _mm256_loadu_ps(numbers[0].data()),
               ofFaces = _mm256_loadu_ps(numbers[1].data()),
               ofEdges = _mm256_loadu_ps(numbers[3].data()),
               ofCorners = _mm256_loadu_ps(numbers[7].data());
  const auto weighed = [&](__m256i own, __m256i faces, __m256i edges, __m256i corners) RESECT_AVX2 {
    return _mm256_add_ps(
        _mm256_add_ps(_mm256_mul_ps(colour(own), ofOwn), _mm256_mul_ps(colour(faces), ofFaces)),
        _mm256_add_ps(_mm256_mul_ps(colour(edges), ofEdges),
                      _mm256_mul_ps(colour(corners), ofCorners)));
  };
  const __m256i lower = _mm256_set1_epi32(0xffff);
  const auto even = [&](__m256i v) RESECT_AVX2 { return _mm256_and_si256(v, lower); };
  const auto odd = [](__m256i v) RESECT_AVX2 { return _mm256_srli_epi32(v, 16); };
  PlaneSums below = planeSums(low, alongY), level = planeSums(low + alongZ, alongY);
#pragma GCC unroll 4
  for (int plane = 0; plane < kBrickNodes; ++plane, out += kBrickNodes * kBrickNodes) {
    const PlaneSums above = planeSums(low + (plane + 2) * alongZ, alongY);
    const __m256i own = level.own,
                  faces = _mm256_add_epi16(level.beside, _mm256_add_epi16(below.own, above.own)),
                  edges =
                      _mm256_add_epi16(level.across, _mm256_add_epi16(below.beside, above.beside)),
                  corners = _mm256_add_epi16(below.across, above.across);
    below = level;
    level = above;
    if (!(planes >> plane & 1)) continue;
    // Even and odd nodes apart: widening then needs no shuffle.
    const __m256 first = weighed(even(own), even(faces), even(edges), even(corners)),
                 second = weighed(odd(own), odd(faces), odd(edges), odd(corners));
    const __m256 rows02 = _mm256_unpacklo_ps(first, second),
                 rows13 = _mm256_unpackhi_ps(first, second);
    _mm_storeu_ps(out, _mm256_castps256_ps128(rows02));
    _mm_storeu_ps(out + kBrickNodes, _mm256_castps256_ps128(rows13));
    _mm_storeu_ps(out + 2 * kBrickNodes, _mm256_extractf128_ps(rows02, 1));
    _mm_storeu_ps(out + 3 * kBrickNodes, _mm256_extractf128_ps(rows13, 1));
  }
}

// ---- two nodes a cell ----

// Two neighbouring rows of cells: for each node the near sum along x, then the far sum.
RESECT_AVX2 inline __m256i pairOfRows(__m128i first, __m128i second) {
  return alongX(first, second, _mm_setr_epi8(1, -1, 1, 2, 2, -1, 2, 3, 0, 2, 0, 3, 1, 3, 1, 4));
}

// Converts near and far sums along y to colour values, in the layout of weighBetween().
RESECT_AVX2 inline void widen(__m256i near, __m256i far, Half* to) {
  const __m256i zero = _mm256_setzero_si256();
  to[0] = colour(_mm256_unpacklo_epi16(near, zero));
  to[1] = colour(_mm256_unpackhi_epi16(near, zero));
  to[2] = colour(_mm256_unpacklo_epi16(far, zero));
  to[3] = colour(_mm256_unpackhi_epi16(far, zero));
}

// As sumBetweenCells() in field_stencil.cpp, with integer sums along x and y.
RESECT_AVX2 void sumLevelsBetween(const FieldStencil& stencil, const Level* low,
                                  std::ptrdiff_t alongY, std::ptrdiff_t alongZ, unsigned planes,
                                  float* out) {
  SumsBetween sums;
#pragma GCC unroll 5
  for (int z = 0; z < kCellsBetween; ++z, low += alongZ) {
    const __m128i third = rowAt(low + 3 * alongY);
    const __m256i rows01 = pairOfRows(rowAt(low), rowAt(low + alongY)),
                  rows23 = pairOfRows(rowAt(low + 2 * alongY), third),
                  rows34 = pairOfRows(third, rowAt(low + 4 * alongY)),
                  rows12 = _mm256_permute2x128_si256(rows01, rows23, 0x21);
    widen(rows12, _mm256_add_epi16(rows01, rows23), sums[0][z]);
    widen(_mm256_add_epi16(rows12, rows23), _mm256_add_epi16(rows01, rows34), sums[1][z]);
  }
  weighBetween(stencil, sums, planes, out);
}

#endif

}  // namespace

void sumBrickPlainly(const FieldStencil& stencil, const Vec3i& phase, const Level* low,
                     std::ptrdiff_t alongY, std::ptrdiff_t alongZ, unsigned planes, float* out) {
  float window[kWindow * kWindow * kWindowRow];
  widenPlainly(low, alongY, alongZ, sideOf(stencil), window);
  sumBrick(stencil, phase, window, kWindowRow, kWindow * kWindowRow, planes, out);
}

void sumBrick(const FieldStencil& stencil, const Vec3i& phase, const Level* low,
              std::ptrdiff_t alongY, std::ptrdiff_t alongZ, unsigned planes, float* out) {
#if defined(__x86_64__)
  static const bool wide = __builtin_cpu_supports("avx2");
  if (wide && stencil.refine == 1) return sumLevels(stencil, low, alongY, alongZ, planes, out);
  if (wide && stencil.refine == 2)
    return sumLevelsBetween(stencil, low, alongY, alongZ, planes, out);
  if (wide) {
    alignas(32) float window[kWindow * kWindow * kWindowRow];
    widenRows(low, alongY, alongZ, sideOf(stencil), window);
    return sumBrick(stencil, phase, window, kWindowRow, kWindow * kWindowRow, planes, out);
  }
#endif
  sumBrickPlainly(stencil, phase, low, alongY, alongZ, planes, out);
}

}  // namespace resect
