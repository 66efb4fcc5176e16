#include "collision/lone_columns.h"

#include "base/instruction_set.h"
#include "collision/avx2_integers.h"
#include "collision/footprint.h"

namespace resect {
namespace {

// Column and row.
IntPair load(const GridCell& cell) {
  IntPair both;
  __builtin_memcpy(&both, &cell, sizeof both);
  return both;
}

}  // namespace

// Everything is written, and kept by counting it: a branch that goes one way as often as the other
// costs more than a triangle.
RESECT_WIDEST SortedOut sortOut(std::span<const Triangle> triangles, const GridCell* cells,
                                std::size_t begin, std::size_t end, LoneColumn* lone,
                                std::uint32_t* others) {
  SortedOut count;
  for (std::size_t t = begin; t < end; ++t) {
    const auto& [ia, ib, ic] = triangles[t];
    const IntPair a = load(cells[ia]), b = load(cells[ib]), c = load(cells[ic]);
    IntPair low = a < b ? a : b, high = a > b ? a : b;
    low = low < c ? low : c;
    high = high > c ? high : c;
    const IntPair size = high - low;
    std::uint64_t sizes;  // of columns in the lower half, of rows in the upper
    __builtin_memcpy(&sizes, &size, sizeof sizes);
    const bool single = sizes == 0x1'0000'0001;
    lone[count.lone].triangle = std::uint32_t(t);
    __builtin_memcpy(&lone[count.lone].at, &low, sizeof low);
    others[count.others] = std::uint32_t(t);
    count.lone += single;
    count.others += (std::uint32_t(sizes) != 0) & (sizes >> 32 != 0) & !single;
  }
  return count;
}

LoneHit* castLonePlainly(const SnappedMesh& mesh, const GridRaster& raster, const LoneColumn* lone,
                         std::size_t count, LoneHit* to) {
  for (std::size_t k = 0; k < count; ++k) {
    const auto& [t, at] = lone[k];
    const auto& [a, b, c] = mesh.triangles[t];
    const Footprint footprint(mesh.points[a], mesh.points[b], mesh.points[c]);
    const auto place = footprint.row(raster.rows[at.row]).place(raster.columns[at.column]);
    *to = {at.row, {at.column, footprint.sign, footprint.depth(place)}};
    to += place.covered() & (footprint.area > 0);
  }
  return to;
}

#if defined(__x86_64__)

namespace {

// x of a place in the lower half of each of four numbers, y in the upper.
using Places = __m256i;

RESECT_AVX2 inline Places placesOf(const SnappedMesh::Point* const* p) {
  std::int64_t xy[4];
  for (int k = 0; k < 4; ++k) __builtin_memcpy(&xy[k], p[k], sizeof xy[k]);
  return _mm256_set_epi64x(xy[3], xy[2], xy[1], xy[0]);
}
RESECT_AVX2 inline __m256d depthsOf(const SnappedMesh::Point* const* p) {
  return _mm256_set_pd(p[3]->z, p[2]->z, p[1]->z, p[0]->z);
}

// Products of 32-bit numbers are exact in 64 bits.
RESECT_AVX2 inline __m256i cross(Places a, Places b) {
  return _mm256_sub_epi64(_mm256_mul_epi32(a, _mm256_srli_epi64(b, 32)),
                          _mm256_mul_epi32(_mm256_srli_epi64(a, 32), b));
}

// Is `v`, the value of an edge (after turning), on the covered side, or zero and the edge owns it
// (Footprint::makeEdge)?
RESECT_AVX2 inline __m256i onSide(__m256i v, Places edge, __m256i turn) {
  const __m256i upper = _mm256_set1_epi64x(std::int64_t(0xffff'ffff'0000'0000));
  // dx - 2^32 dy > 0: dy < 0, or dy = 0 and dx > 0.
  const __m256i owns = _mm256_sub_epi64(_mm256_mul_epi32(edge, _mm256_set1_epi64x(1)),
                                        _mm256_and_si256(edge, upper));
  const __m256i owned = _mm256_cmpgt_epi64(turned(owns, turn), _mm256_setzero_si256());
  return _mm256_cmpgt_epi64(v, owned);  // > -1 or > 0
}

// Edge functions of a column at the origin are cross products of the corners.
RESECT_AVX2 LoneHit* castFours(const SnappedMesh& mesh, const GridRaster& raster,
                               const LoneColumn* lone, std::size_t count, LoneHit* to) {
  const SnappedMesh::Point* points = mesh.points.data();
  for (; count >= 4; count -= 4, lone += 4) {
    const SnappedMesh::Point* corner[3][4];
    std::int32_t line[8];
    for (int k = 0; k < 4; ++k) {
      for (std::size_t i = 0; i < 3; ++i)
        corner[i][k] = points + mesh.triangles[lone[k].triangle][i];
      line[2 * k] = raster.columns[lone[k].at.column];
      line[2 * k + 1] = raster.rows[lone[k].at.row];
    }
    const Places origin = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(line));
    const Places a = _mm256_sub_epi32(placesOf(corner[0]), origin);
    const Places b = _mm256_sub_epi32(placesOf(corner[1]), origin);
    const Places c = _mm256_sub_epi32(placesOf(corner[2]), origin);
    const __m256i v0 = cross(b, c), v1 = cross(c, a), v2 = cross(a, b);
    const __m256i twice = _mm256_add_epi64(v0, _mm256_add_epi64(v1, v2));
    const __m256i zero = _mm256_setzero_si256();
    const __m256i looksUp = _mm256_cmpgt_epi64(twice, zero);
    const __m256i turn = _mm256_xor_si256(looksUp, _mm256_set1_epi64x(-1));
    const __m256i w0 = turned(v0, turn), w1 = turned(v1, turn), w2 = turned(v2, turn);
    __m256i covered = _mm256_and_si256(onSide(w0, _mm256_sub_epi32(c, b), turn),
                                       onSide(w1, _mm256_sub_epi32(a, c), turn));
    covered = _mm256_and_si256(covered, onSide(w2, _mm256_sub_epi32(b, a), turn));
    covered = _mm256_andnot_si256(_mm256_cmpeq_epi64(twice, zero), covered);

    const __m256d z = depthsOf(corner[0]);
    const __m256d rise1 = _mm256_sub_pd(depthsOf(corner[1]), z);
    const __m256d rise2 = _mm256_sub_pd(depthsOf(corner[2]), z);
    const __m256d rise =
        _mm256_add_pd(_mm256_mul_pd(toDouble(w1), rise1), _mm256_mul_pd(toDouble(w2), rise2));
    alignas(32) double depth[4];
    _mm256_store_pd(depth, _mm256_add_pd(z, _mm256_div_pd(rise, toDouble(turned(twice, turn)))));
    const int hit = _mm256_movemask_pd(_mm256_castsi256_pd(covered));
    const int up = _mm256_movemask_pd(_mm256_castsi256_pd(looksUp));
    for (int k = 0; k < 4; ++k) {
      const GridCell& at = lone[k].at;
      *to = {at.row, {at.column, 1 - 2 * (up >> k & 1), depth[k]}};
      to += hit >> k & 1;
    }
  }
  return castLonePlainly(mesh, raster, lone, count, to);
}

}  // namespace

LoneHit* castLone(const SnappedMesh& mesh, const GridRaster& raster, const LoneColumn* lone,
                  std::size_t count, LoneHit* to) {
  static const bool wide = __builtin_cpu_supports("avx2");
  return (wide ? castFours : castLonePlainly)(mesh, raster, lone, count, to);
}

#else

LoneHit* castLone(const SnappedMesh& mesh, const GridRaster& raster, const LoneColumn* lone,
                  std::size_t count, LoneHit* to) {
  return castLonePlainly(mesh, raster, lone, count, to);
}

#endif

}  // namespace resect
