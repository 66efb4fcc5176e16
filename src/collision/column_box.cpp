#include "collision/column_box.h"

#include <algorithm>
#include <array>
#include <bit>

#include "collision/avx2_integers.h"

namespace resect {

GridHit* castBoxPlainly(const Footprint& footprint, const GridRaster& raster, const ColumnBox& box,
                        GridHit* to) {
  for (int y = box.first.row; y < box.last.row; ++y) {
    const Footprint::Row row = footprint.row(raster.rows[y]);
    for (int x = box.first.column; x < box.last.column; ++x) {
      const auto place = row.place(raster.columns[x]);
      *to = {raster.column({x, y}), footprint.sign, footprint.depth(place)};
      to += place.covered();
    }
  }
  return to;
}

#if defined(__x86_64__)

namespace {

// For each set of four lanes: where each of those in it stands, by halves, those first.
constexpr std::array<std::array<std::int32_t, 8>, 16> kPacked = [] {
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

// The part of the edge functions that the columns of a step decide is worked out once for all rows.
// Aims at 45 instructions for a row of four columns.
RESECT_AVX2 GridHit* castBoxFours(const Footprint& footprint, const GridRaster& raster,
                                  const ColumnBox& box, GridHit* to) {
  // Products of 32-bit numbers are exact in 64 bits: sides and distances are below 2^31.
  const auto all = [](std::int64_t v) RESECT_AVX2 { return _mm256_set1_epi64x(v); };
  const __m256i dx[3] = {all(footprint.edge[0].dx), all(footprint.edge[1].dx),
                         all(footprint.edge[2].dx)};
  const __m256i notOwned1 = all(footprint.edge[1].notOwned),
                notOwned2 = all(footprint.edge[2].notOwned);
  const __m256d z = _mm256_set1_pd(footprint.z), rise1 = _mm256_set1_pd(footprint.dz1),
                rise2 = _mm256_set1_pd(footprint.dz2), area = _mm256_set1_pd(footprint.area);
  for (int x = box.first.column; x < box.last.column; x += kBoxStep) {
    const __m256i columns =
        _mm256_sub_epi64(_mm256_cvtepi32_epi64(
                             _mm_loadu_si128(reinterpret_cast<const __m128i*>(raster.columns + x))),
                         all(footprint.x0));
    __m256i start[3];
    for (int e = 0; e < 3; ++e)
      start[e] = _mm256_sub_epi64(all(footprint.edge[e].start),
                                  _mm256_mul_epi32(columns, all(footprint.edge[e].dy)));
    const unsigned within = (1u << std::min(kBoxStep, box.last.column - x)) - 1;
    // Column and sign of a hit, as they stand in memory.
    const std::uint32_t first = raster.column({x, box.first.row});
    __m256i hit = _mm256_add_epi64(
        all(std::int64_t(std::uint64_t(std::uint32_t(footprint.sign)) << 32 | first)),
        _mm256_set_epi64x(3, 2, 1, 0));
    for (int y = box.first.row; y < box.last.row; ++y) {
      const __m256i row = all(raster.rows[y] - footprint.y0);
      const auto value = [&](int e) RESECT_AVX2 {
        return _mm256_add_epi64(start[e], _mm256_mul_epi32(dx[e], row));
      };
      const __m256i v0 = value(0), v1 = value(1), v2 = value(2);
      const __m256i any = _mm256_or_si256(v0, _mm256_or_si256(v1, v2));
      const unsigned covered = ~unsigned(_mm256_movemask_pd(_mm256_castsi256_pd(any))) & within;
      const __m256d rise =
          _mm256_add_pd(_mm256_mul_pd(toDouble(_mm256_add_epi64(v1, notOwned1)), rise1),
                        _mm256_mul_pd(toDouble(_mm256_add_epi64(v2, notOwned2)), rise2));
      const __m256i depth = _mm256_castpd_si256(_mm256_add_pd(z, _mm256_div_pd(rise, area)));
      const __m256i order =
          _mm256_loadu_si256(reinterpret_cast<const __m256i*>(kPacked[covered].data()));
      const __m256i hits = _mm256_permutevar8x32_epi32(hit, order),
                    depths = _mm256_permutevar8x32_epi32(depth, order);
      const __m256i even = _mm256_unpacklo_epi64(hits, depths),
                    odd = _mm256_unpackhi_epi64(hits, depths);
      auto* out = reinterpret_cast<__m256i*>(to);
      _mm256_storeu_si256(out, _mm256_permute2x128_si256(even, odd, 0x20));
      _mm256_storeu_si256(out + 1, _mm256_permute2x128_si256(even, odd, 0x31));
      to += std::popcount(covered);
      hit = _mm256_add_epi64(hit, all(raster.columnCount));
    }
  }
  return to;
}

}  // namespace

GridHit* castBox(const Footprint& footprint, const GridRaster& raster, const ColumnBox& box,
                 GridHit* to) {
  static const bool wide = __builtin_cpu_supports("avx2");
  return (wide ? castBoxFours : castBoxPlainly)(footprint, raster, box, to);
}

#else

GridHit* castBox(const Footprint& footprint, const GridRaster& raster, const ColumnBox& box,
                 GridHit* to) {
  return castBoxPlainly(footprint, raster, box, to);
}

#endif

}  // namespace resect
