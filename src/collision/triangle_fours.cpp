#include "collision/triangle_fours.h"

#if defined(__x86_64__)
#include <algorithm>
#include <cmath>

#include "collision/avx2_integers.h"
#include "collision/step_tiles.h"

namespace resect {
namespace {

// Pairs of 32-bit numbers, four of each half: columns and rows, or x and y.
struct Halves {
  __m128i first, second;
};
RESECT_AVX2 inline Halves halvesOf(__m256i pairs) {
  const __m256i apart =
      _mm256_permutevar8x32_epi32(pairs, _mm256_setr_epi32(0, 2, 4, 6, 1, 3, 5, 7));
  return {_mm256_castsi256_si128(apart), _mm256_extracti128_si256(apart, 1)};
}

// Four pairs of 32-bit numbers from anywhere.
template <typename At>
RESECT_AVX2 inline __m256i gathered(const At& at) {
  std::int64_t both[4];
  for (std::size_t k = 0; k < 4; ++k) __builtin_memcpy(&both[k], at(k), sizeof both[k]);
  return _mm256_set_epi64x(both[3], both[2], both[1], both[0]);
}

RESECT_AVX2 inline __m256d size(__m256d v) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), v); }
RESECT_AVX2 inline void keep(float* to, __m256d v) { _mm_store_ps(to, _mm256_cvtpd_ps(v)); }
RESECT_AVX2 inline void keep(std::int32_t* to, __m128i v) {
  _mm_store_si128(reinterpret_cast<__m128i*>(to), v);
}

constexpr double kEightRoundings = 0x1p-21;

}  // namespace

// Aims at 45 instructions a triangle.
RESECT_AVX2_FMA void prepare(const MeshOnGrid& placed, const SampleLine& line, double lineSlack,
                             const std::uint64_t* triangles, TriangleFour& four) {
  const SnappedMesh& mesh = placed.mesh;
  const std::int32_t* corners[4];
  for (std::size_t k = 0; k < 4; ++k) corners[k] = mesh.triangles[triangles[k]].data();
  __m256i places[3], cells[3];
  __m256d depths[3];
  for (std::size_t c = 0; c < 3; ++c) {
    const auto corner = [&](std::size_t k) { return std::size_t(corners[k][c]); };
    places[c] = gathered([&](std::size_t k) { return &mesh.places[corner(k)]; });
    cells[c] = gathered([&](std::size_t k) { return &placed.cells[corner(k)]; });
    const auto z = [&](std::size_t k) { return mesh.points[corner(k)].z(); };
    depths[c] = _mm256_setr_pd(z(0), z(1), z(2), z(3));
  }
  const Halves from = halvesOf(places[0]);
  keep(four.x0, from.first);
  keep(four.y0, from.second);
  static_assert(kTileColumns == 4 && kTileRows == 2);
  const __m256i shifts = _mm256_setr_epi32(2, 1, 2, 1, 2, 1, 2, 1);
  const __m256i low = _mm256_min_epi32(_mm256_min_epi32(cells[0], cells[1]), cells[2]),
                high = _mm256_max_epi32(_mm256_max_epi32(cells[0], cells[1]), cells[2]);
  const Halves first = halvesOf(_mm256_srlv_epi32(low, shifts)),
               last = halvesOf(
                   _mm256_srlv_epi32(_mm256_sub_epi32(high, _mm256_set1_epi32(1)), shifts));
  keep(four.left, first.first);
  keep(four.bottom, first.second);
  keep(four.right, last.first);
  keep(four.top, last.second);

  const Halves toB = halvesOf(_mm256_sub_epi32(places[1], places[0])),
               toC = halvesOf(_mm256_sub_epi32(places[2], places[0]));
  const Halves sides = halvesOf(
      _mm256_sub_epi32(_mm256_max_epi32(_mm256_max_epi32(places[0], places[1]), places[2]),
                       _mm256_min_epi32(_mm256_min_epi32(places[0], places[1]), places[2])));
  const __m256d bx = _mm256_cvtepi32_pd(toB.first), by = _mm256_cvtepi32_pd(toB.second),
                cx = _mm256_cvtepi32_pd(toC.first), cy = _mm256_cvtepi32_pd(toC.second),
                w = _mm256_cvtepi32_pd(sides.first), h = _mm256_cvtepi32_pd(sides.second);
  const __m256d twice = _mm256_fmsub_pd(bx, cy, _mm256_mul_pd(by, cx));
  const __m256d down = _mm256_and_pd(twice, _mm256_set1_pd(-0.0)), area = size(twice);
  const auto turned = [&](__m256d v) RESECT_AVX2 { return _mm256_xor_pd(v, down); };
  const __m256d up = _mm256_xor_pd(down, _mm256_set1_pd(-0.0));
  const auto against = [&](__m256d v) RESECT_AVX2 { return _mm256_xor_pd(v, up); };
  const __m256d dx[3] = {turned(_mm256_sub_pd(cx, bx)), against(cx), turned(bx)},
                dy[3] = {turned(_mm256_sub_pd(cy, by)), against(cy), turned(by)};
  keep(four.leaves,
       _mm_add_epi32(_mm_set1_epi32(1), _mm256_castsi256_si128(_mm256_permutevar8x32_epi32(
                                            _mm256_srai_epi32(_mm256_castpd_si256(down), 31),
                                            _mm256_setr_epi32(1, 3, 5, 7, 1, 3, 5, 7)))));

  const auto stepsOf = [](const GridLines& lines, int count) {
    return std::min(count / lines.linesPerStep, 0x1p31) + 2;  // columns end beside the raster
  };
  const __m256d wh = _mm256_mul_pd(w, h);
  const __m256d row = _mm256_set1_pd(stepsOf(placed.rows, 1)),
                columns = _mm256_set1_pd(stepsOf(placed.columns, 3));
  const __m256d doubt = _mm256_mul_pd(
      _mm256_set1_pd(kEightRoundings),
      _mm256_fmadd_pd(wh, _mm256_set1_pd(3), _mm256_fmadd_pd(w, row, _mm256_mul_pd(h, columns))));
  keep(four.start0, _mm256_sub_pd(area, doubt));
  keep(four.doubt, doubt);
  for (std::size_t e = 0; e < 3; ++e) {
    keep(four.dx[e], dx[e]);
    keep(four.dy[e], dy[e]);
  }

  const __m256d z = depths[0], dz1 = _mm256_sub_pd(depths[1], z), dz2 = _mm256_sub_pd(depths[2], z);
  const __m256d perPitch = _mm256_set1_pd(1 / line.pitch), scale = _mm256_div_pd(perPitch, area);
  const __m256d cyz = _mm256_mul_pd(cy, dz1), byz = _mm256_mul_pd(by, dz2),
                cxz = _mm256_mul_pd(cx, dz1), bxz = _mm256_mul_pd(bx, dz2);
  keep(four.gx, _mm256_mul_pd(turned(_mm256_sub_pd(cyz, byz)), scale));
  keep(four.gy, _mm256_mul_pd(turned(_mm256_sub_pd(bxz, cxz)), scale));
  const __m256d p0 =
      _mm256_fmadd_pd(_mm256_sub_pd(z, _mm256_set1_pd(line.first)), perPitch, _mm256_set1_pd(1));
  const __m256d rise =
      _mm256_mul_pd(_mm256_fmadd_pd(_mm256_add_pd(size(cyz), size(byz)), w,
                                    _mm256_mul_pd(_mm256_add_pd(size(cxz), size(bxz)), h)),
                    scale);
  const __m256d deep = _mm256_mul_pd(_mm256_add_pd(size(z), _mm256_add_pd(size(dz1), size(dz2))),
                                     _mm256_mul_pd(perPitch, _mm256_set1_pd(1e-14)));
  const __m256d slack =
      _mm256_fmadd_pd(_mm256_set1_pd(kEightRoundings), _mm256_add_pd(size(p0), rise),
                      _mm256_add_pd(deep, _mm256_set1_pd(lineSlack)));
  keep(four.p0, _mm256_sub_pd(p0, slack));
  keep(four.twoSlacks, _mm256_add_pd(slack, slack));
  const __m256d sure =
      _mm256_and_pd(_mm256_cmp_pd(slack, _mm256_set1_pd(0.2), _CMP_LT_OQ),
                    _mm256_cmp_pd(area, _mm256_mul_pd(wh, _mm256_set1_pd(0x1p-20)), _CMP_GT_OQ));
  four.filtered = unsigned(_mm256_movemask_pd(sure));
}

}  // namespace resect

#endif
