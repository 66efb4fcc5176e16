#include "collision/column_box.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

#include "collision/avx2_integers.h"

namespace resect {

void castBoxPlainly(const Footprint& footprint, const GridRaster& raster, const ColumnBox& box,
                    RowHits& hits) {
  for (int y = box.first.row; y < box.last.row; ++y) {
    const Footprint::Row row = footprint.row(raster.rows[y]);
    RowHits::Row& into = hits.rows()[y];
    GridHit* to = hits.room(into, box.last.column - box.first.column + 1);
    for (int x = box.first.column; x < box.last.column; ++x) {
      const auto place = row.place(raster.columns[x]);
      *to = {x, footprint.sign, footprint.depth(place)};
      to += place.covered();
    }
    into.end = to;
  }
}

#if defined(__x86_64__)

namespace {

// Edge functions as integers: products of 32-bit numbers are exact in 64 bits.
struct Integers {
  using Four = __m256i;
  RESECT_AVX2 static Four all(std::int64_t v) { return _mm256_set1_epi64x(v); }
  RESECT_AVX2 static Four from(__m128i v) { return _mm256_cvtepi32_epi64(v); }
  RESECT_AVX2 static Four sum(Four a, Four b) { return _mm256_add_epi64(a, b); }
  RESECT_AVX2 static Four difference(Four a, Four b) { return _mm256_sub_epi64(a, b); }
  RESECT_AVX2 static Four product(Four a, Four b) { return _mm256_mul_epi32(a, b); }
  RESECT_AVX2 static __m256d number(Four v) { return toDouble(v); }
  RESECT_AVX2 static __m256d signs(Four v) { return _mm256_castsi256_pd(v); }
};

// The same as floating-point numbers, for triangles so small that all their integers are exact.
struct SmallIntegers {
  using Four = __m256d;
  RESECT_AVX2 static Four all(std::int64_t v) { return _mm256_set1_pd(double(v)); }
  RESECT_AVX2 static Four from(__m128i v) { return _mm256_cvtepi32_pd(v); }
  RESECT_AVX2 static Four sum(Four a, Four b) { return _mm256_add_pd(a, b); }
  RESECT_AVX2 static Four difference(Four a, Four b) { return _mm256_sub_pd(a, b); }
  RESECT_AVX2 static Four product(Four a, Four b) { return _mm256_mul_pd(a, b); }
  RESECT_AVX2 static __m256d number(Four v) { return v; }
  RESECT_AVX2 static __m256d signs(Four v) { return v; }
};

// With sides below 2^26 products stay below 2^52, and so does twice the area. A column of the box
// lies no further from an edge's end than the sides are long, so what `start` less a product, and
// the whole edge function, amounts to stays below 2^53.
bool isSmall(const Footprint& f) {
  const auto far = [](const Footprint::Edge& e) { return std::abs(e.dx) | std::abs(e.dy); };
  return (far(f.edge[0]) | far(f.edge[1]) | far(f.edge[2])) < 1 << 26;
}

// The part of the edge functions that the columns of a step decide is worked out once for all rows.
// Aims at 35 instructions for a row of four columns, 45 with integers.
template <typename N>
RESECT_AVX2 void castBoxFours(const Footprint& footprint, const GridRaster& raster,
                              const ColumnBox& box, RowHits& hits) {
  using Four = typename N::Four;
  const __m128i x0 = _mm_set1_epi32(std::int32_t(footprint.x0)),
                y0 = _mm_set1_epi32(std::int32_t(footprint.y0));
  const Four dx[3] = {N::all(footprint.edge[0].dx), N::all(footprint.edge[1].dx),
                      N::all(footprint.edge[2].dx)};
  const Four notOwned1 = N::all(footprint.edge[1].notOwned),
             notOwned2 = N::all(footprint.edge[2].notOwned);
  const __m256d z = _mm256_set1_pd(footprint.z), rise1 = _mm256_set1_pd(footprint.dz1),
                rise2 = _mm256_set1_pd(footprint.dz2), area = _mm256_set1_pd(footprint.area);
  RowHits::Row* const rows = hits.rows();
  for (int x = box.first.column; x < box.last.column; x += kBoxStep) {
    const Four columns = N::from(
        _mm_sub_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(raster.columns + x)), x0));
    Four start[3];
    for (int e = 0; e < 3; ++e)
      start[e] = N::difference(N::all(footprint.edge[e].start),
                               N::product(columns, N::all(footprint.edge[e].dy)));
    const unsigned within = (1u << std::min(kBoxStep, box.last.column - x)) - 1;
    // Column and sign of a hit, as they stand in memory.
    const __m256i hit = _mm256_add_epi64(
        _mm256_set1_epi64x(
            std::int64_t(std::uint64_t(std::uint32_t(footprint.sign)) << 32 | std::uint32_t(x))),
        _mm256_set_epi64x(3, 2, 1, 0));
    for (int y = box.first.row; y < box.last.row; ++y) {
      const Four row = N::from(_mm_sub_epi32(_mm_set1_epi32(raster.rows[y]), y0));
      const Four v0 = N::sum(start[0], N::product(dx[0], row)),
                 v1 = N::sum(start[1], N::product(dx[1], row)),
                 v2 = N::sum(start[2], N::product(dx[2], row));
      const __m256d any = _mm256_or_pd(N::signs(v0), _mm256_or_pd(N::signs(v1), N::signs(v2)));
      const unsigned covered = ~unsigned(_mm256_movemask_pd(any)) & within;
      const __m256d rise = _mm256_add_pd(_mm256_mul_pd(N::number(N::sum(v1, notOwned1)), rise1),
                                         _mm256_mul_pd(N::number(N::sum(v2, notOwned2)), rise2));
      const __m256i depth = _mm256_castpd_si256(_mm256_add_pd(z, _mm256_div_pd(rise, area)));
      RowHits::Row& into = rows[y];
      storePairs(packed(hit, covered), packed(depth, covered), hits.room(into, kBoxStep));
      into.end += std::popcount(covered);
    }
  }
}

}  // namespace

void castBox(const Footprint& footprint, const GridRaster& raster, const ColumnBox& box,
             RowHits& hits) {
  static const bool wide = __builtin_cpu_supports("avx2");
  if (!wide)
    castBoxPlainly(footprint, raster, box, hits);
  else if (isSmall(footprint))
    castBoxFours<SmallIntegers>(footprint, raster, box, hits);
  else
    castBoxFours<Integers>(footprint, raster, box, hits);
}

#else

void castBox(const Footprint& footprint, const GridRaster& raster, const ColumnBox& box,
             RowHits& hits) {
  castBoxPlainly(footprint, raster, box, hits);
}

#endif

}  // namespace resect
