#include "collision/lone_columns.h"

#include <algorithm>
#include <bit>

#include "base/instruction_set.h"
#include "collision/avx2_integers.h"
#include "collision/footprint.h"

namespace resect {

// Everything is written, and kept by counting it: a branch that goes one way as often as the other
// costs more than a triangle.
SortedOut sortOutPlainly(std::span<const Triangle> triangles, const GridCell* cells,
                         std::size_t begin, std::size_t end, LoneColumn* lone,
                         std::uint64_t* others) {
  SortedOut count;
  for (std::size_t t = begin; t < end; ++t) {
    const auto& [ia, ib, ic] = triangles[t];
    const GridCell &a = cells[ia], &b = cells[ib], &c = cells[ic];
    const auto [left, right] = std::minmax({a.column, b.column, c.column});
    const auto [lowest, highest] = std::minmax({a.row, b.row, c.row});
    const bool some = (left < right) & (lowest < highest);
    const bool single = (right - left == 1) & (highest - lowest == 1);
    lone[count.lone] = {t, {left, lowest}};
    others[count.others] = t;
    count.lone += single;
    count.others += some & !single;
  }
  return count;
}

std::size_t keepCoveringPlainly(const SnappedMesh& mesh, const GridRaster& raster, LoneColumn* lone,
                                std::size_t count) {
  LoneColumn* to = lone;
  for (std::size_t k = 0; k < count; ++k) {
    const LoneColumn at = lone[k];
    const Footprint footprint = footprintOf(mesh, at.triangle);
    *to = at;
    to += footprint.row(raster.rows[at.at.row]).place(raster.columns[at.at.column]).covered() &
          (footprint.area > 0);
  }
  return std::size_t(to - lone);
}

#if defined(__x86_64__)

namespace {

// Writes the first ones of four, as many as the set holds.
RESECT_AVX2 inline LoneColumn* store(__m256i triangles, __m256i at, unsigned set, LoneColumn* to) {
  storePairs(triangles, at, to);
  return to + std::popcount(set);
}

// Column and row of a corner of four triangles each.
RESECT_AVX2 inline __m256i cellsOf(const GridCell* cells, const Triangle* t, std::size_t corner) {
  return gathered([&](std::size_t k) { return &cells[t[k][corner]]; });
}

// Aims at 17 instructions a triangle.
RESECT_AVX2 SortedOut sortOutFours(std::span<const Triangle> triangles, const GridCell* cells,
                                   std::size_t begin, std::size_t end, LoneColumn* lone,
                                   std::uint64_t* others) {
  LoneColumn* nextLone = lone;
  std::uint64_t* nextOther = others;
  std::size_t t = begin;
  for (; t + 4 <= end; t += 4) {
    const __m256i a = cellsOf(cells, &triangles[t], 0), b = cellsOf(cells, &triangles[t], 1),
                  c = cellsOf(cells, &triangles[t], 2);
    const __m256i low = _mm256_min_epi32(_mm256_min_epi32(a, b), c),
                  high = _mm256_max_epi32(_mm256_max_epi32(a, b), c);
    const __m256i size = _mm256_sub_epi32(high, low), zero = _mm256_setzero_si256();
    const __m256i some = _mm256_cmpeq_epi64(_mm256_cmpeq_epi32(size, zero), zero),
                  single = _mm256_cmpeq_epi64(size, _mm256_set1_epi64x(0x1'0000'0001));
    const auto kept = unsigned(_mm256_movemask_pd(_mm256_castsi256_pd(single))),
               more = unsigned(_mm256_movemask_pd(_mm256_castsi256_pd(some))) & ~kept;
    const __m256i number =
        _mm256_add_epi64(_mm256_set1_epi64x(std::int64_t(t)), _mm256_set_epi64x(3, 2, 1, 0));
    nextLone = store(packed(number, kept), packed(low, kept), kept, nextLone);
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(nextOther), packed(number, more));
    nextOther += std::popcount(more);
  }
  const SortedOut rest = sortOutPlainly(triangles, cells, t, end, nextLone, nextOther);
  return {std::size_t(nextLone - lone) + rest.lone, std::size_t(nextOther - others) + rest.others};
}

// x of a place in the lower half of each of four numbers, y in the upper.
using Places = __m256i;

// Where a corner of four triangles stands each.
RESECT_AVX2 inline Places placesOf(const SnappedMesh& mesh, const LoneColumn* lone,
                                   std::size_t corner) {
  return gathered([&](std::size_t k) {
    return &mesh.places[std::size_t(mesh.triangles[lone[k].triangle][corner])];
  });
}

// Products of 32-bit numbers are exact in 64 bits.
RESECT_AVX2 inline __m256i cross(Places a, Places b) {
  return _mm256_sub_epi64(_mm256_mul_epi32(a, _mm256_srli_epi64(b, 32)),
                          _mm256_mul_epi32(_mm256_srli_epi64(a, 32), b));
}

// Writes those of four that are in the set, one after the other.
RESECT_AVX2 inline LoneColumn* keep(const LoneColumn* four, unsigned set, LoneColumn* to) {
  const auto* from = reinterpret_cast<const __m256i*>(four);
  const __m256i low = _mm256_loadu_si256(from), high = _mm256_loadu_si256(from + 1);
  const __m256i numbers =
      packed(_mm256_permute4x64_epi64(_mm256_unpacklo_epi64(low, high), 0xd8), set);
  const __m256i at = packed(_mm256_permute4x64_epi64(_mm256_unpackhi_epi64(low, high), 0xd8), set);
  return store(numbers, at, set, to);
}

RESECT_AVX2 inline unsigned signsOf(__m256i v) {
  return unsigned(_mm256_movemask_pd(_mm256_castsi256_pd(v)));
}

// Edge functions of a column at the origin are cross products of the corners: it is covered where
// all three have the same sign. Where one is zero the plain test says whose the edge is. Aims at 28
// instructions a triangle.
RESECT_AVX2 std::size_t keepFours(const SnappedMesh& mesh, const GridRaster& raster,
                                  LoneColumn* lone, std::size_t count) {
  LoneColumn* to = lone;
  std::size_t k = 0;
  for (; k + 4 <= count; k += 4) {
    const LoneColumn* const four = lone + k;
    std::int32_t line[8];
    for (std::size_t i = 0; i < 4; ++i) {
      line[2 * i] = raster.columns[four[i].at.column];
      line[2 * i + 1] = raster.rows[four[i].at.row];
    }
    const Places origin = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(line));
    const Places a = _mm256_sub_epi32(placesOf(mesh, four, 0), origin);
    const Places b = _mm256_sub_epi32(placesOf(mesh, four, 1), origin);
    const Places c = _mm256_sub_epi32(placesOf(mesh, four, 2), origin);
    const __m256i v0 = cross(b, c), v1 = cross(c, a), v2 = cross(a, b);
    const __m256i zero = _mm256_setzero_si256();
    const __m256i onEdge = _mm256_or_si256(
        _mm256_cmpeq_epi64(v0, zero),
        _mm256_or_si256(_mm256_cmpeq_epi64(v1, zero), _mm256_cmpeq_epi64(v2, zero)));
    if (!_mm256_testz_si256(onEdge, onEdge)) [[unlikely]] {
      LoneColumn apart[4];
      std::copy_n(four, 4, apart);
      to = std::copy_n(apart, keepCoveringPlainly(mesh, raster, apart, 4), to);
      continue;
    }
    const unsigned covered = (~signsOf(_mm256_or_si256(v0, _mm256_or_si256(v1, v2))) & 0xf) |
                             signsOf(_mm256_and_si256(v0, _mm256_and_si256(v1, v2)));
    to = keep(four, covered, to);
  }
  LoneColumn* const rest = to;
  to = std::copy(lone + k, lone + count, to);
  return std::size_t(rest - lone) + keepCoveringPlainly(mesh, raster, rest, std::size_t(to - rest));
}

}  // namespace

SortedOut sortOut(std::span<const Triangle> triangles, const GridCell* cells, std::size_t begin,
                  std::size_t end, LoneColumn* lone, std::uint64_t* others) {
  static const bool wide = __builtin_cpu_supports("avx2");
  return (wide ? sortOutFours : sortOutPlainly)(triangles, cells, begin, end, lone, others);
}

std::size_t keepCovering(const SnappedMesh& mesh, const GridRaster& raster, LoneColumn* lone,
                         std::size_t count) {
  static const bool wide = __builtin_cpu_supports("avx2");
  return (wide ? keepFours : keepCoveringPlainly)(mesh, raster, lone, count);
}

#else

SortedOut sortOut(std::span<const Triangle> triangles, const GridCell* cells, std::size_t begin,
                  std::size_t end, LoneColumn* lone, std::uint64_t* others) {
  return sortOutPlainly(triangles, cells, begin, end, lone, others);
}

std::size_t keepCovering(const SnappedMesh& mesh, const GridRaster& raster, LoneColumn* lone,
                         std::size_t count) {
  return keepCoveringPlainly(mesh, raster, lone, count);
}

#endif

}  // namespace resect
