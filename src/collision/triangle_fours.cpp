#include "collision/triangle_fours.h"

#if defined(__x86_64__)
#include <algorithm>
#include <cmath>
#include <limits>

#include "collision/avx2_integers.h"

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

RESECT_AVX2 inline __m256d size(__m256d v) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), v); }
RESECT_AVX2 inline __m256d minus(__m256d v) { return _mm256_xor_pd(v, _mm256_set1_pd(-0.0)); }
RESECT_AVX2 inline void keep(float* to, __m256d v) { _mm_store_ps(to, _mm256_cvtpd_ps(v)); }
RESECT_AVX2 inline void keep(std::int32_t* to, __m128i v) {
  _mm_store_si128(reinterpret_cast<__m128i*>(to), v);
}

constexpr double kEightRoundings = 0x1p-21, kSixteenRoundings = 0x1p-20;

// What the mesh says of the corners of four triangles.
struct Corners {
  __m256i place[3];  // on the raster: x and y
  __m256 about[3];   // the same in columns and rows
  __m256d z[3];
};
RESECT_AVX2 inline Corners gatherCorners(const RoughMesh& placed,
                                         const std::int32_t (&triangles)[4]) {
  const SnappedMesh& mesh = placed.mesh;
  const std::int32_t* numbers[4];
  for (std::size_t k = 0; k < 4; ++k) numbers[k] = mesh.triangles[std::size_t(triangles[k])].data();
  Corners corners;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto corner = [&](std::size_t k) { return std::size_t(numbers[k][c]); };
    corners.place[c] = gathered([&](std::size_t k) { return &mesh.places[corner(k)]; });
    corners.about[c] =
        _mm256_castsi256_ps(gathered([&](std::size_t k) { return &placed.points[corner(k)]; }));
    const auto z = [&](std::size_t k) { return mesh.points[corner(k)].z(); };
    corners.z[c] = _mm256_setr_pd(z(0), z(1), z(2), z(3));
  }
  return corners;
}

// Writes the columns and rows of the boxes; returns the first column of each.
RESECT_AVX2 inline __m128i keepBoxes(const RoughMesh& placed, const __m256 (&about)[3],
                                     TriangleFour& four) {
  const float columnCount = float(placed.columns.count), rowCount = float(placed.rows.count);
  const __m256 most = _mm256_setr_ps(columnCount, rowCount, columnCount, rowCount, columnCount,
                                     rowCount, columnCount, rowCount);
  const auto lineOf = [&](__m256 v) RESECT_AVX2 {
    return halvesOf(_mm256_cvtps_epi32(
        _mm256_min_ps(_mm256_max_ps(_mm256_round_ps(v, _MM_FROUND_TO_POS_INF | _MM_FROUND_NO_EXC),
                                    _mm256_setzero_ps()),
                      most)));
  };
  const Halves first = lineOf(_mm256_min_ps(_mm256_min_ps(about[0], about[1]), about[2])),
               last = lineOf(_mm256_max_ps(_mm256_max_ps(about[0], about[1]), about[2]));
  keep(four.firstColumn, first.first);
  keep(four.firstRow, first.second);
  keep(four.lastRow, last.second);
  _mm_store_ps(four.columns, _mm_cvtepi32_ps(_mm_sub_epi32(last.first, first.first)));
  return first.first;
}

// Of four triangles on the raster: sides from corner 0 to b and c, width and height of the box.
struct Outlines {
  __m256d bx, by, cx, cy, width, height, area;  // area: twice the triangle's
  __m256d down;  // the sign bit where corners turn to the right: the surface faces down
};
RESECT_AVX2_FMA inline Outlines outlinesOf(const __m256i (&place)[3]) {
  const Halves toB = halvesOf(_mm256_sub_epi32(place[1], place[0])),
               toC = halvesOf(_mm256_sub_epi32(place[2], place[0]));
  const Halves sides =
      halvesOf(_mm256_sub_epi32(_mm256_max_epi32(_mm256_max_epi32(place[0], place[1]), place[2]),
                                _mm256_min_epi32(_mm256_min_epi32(place[0], place[1]), place[2])));
  Outlines o;
  o.bx = _mm256_cvtepi32_pd(toB.first), o.by = _mm256_cvtepi32_pd(toB.second);
  o.cx = _mm256_cvtepi32_pd(toC.first), o.cy = _mm256_cvtepi32_pd(toC.second);
  o.width = _mm256_cvtepi32_pd(sides.first), o.height = _mm256_cvtepi32_pd(sides.second);
  const __m256d twice = _mm256_fmsub_pd(o.bx, o.cy, _mm256_mul_pd(o.by, o.cx));
  o.down = _mm256_and_pd(twice, _mm256_set1_pd(-0.0));
  o.area = size(twice);
  return o;
}

// Where an edge of sides dx and dy, which lies at `end` at its corner, ends its rows.
RESECT_AVX2_FMA inline void keepEdge(std::size_t e, __m256d dx, __m256d dy, __m256d end,
                                     __m256d slack, __m256d down, __m256d perStep,
                                     TriangleFour& four) {
  const __m256d beyond = _mm256_set1_pd(std::numeric_limits<double>::infinity()),
                before = _mm256_set1_pd(-std::numeric_limits<double>::infinity());
  const __m256d level = _mm256_cmp_pd(dy, _mm256_setzero_pd(), _CMP_EQ_OQ);
  const __m256d onLeft = _mm256_xor_pd(dy, down);  // sign: edges run down there
  const __m256d there = _mm256_sub_pd(end, slack);
  keep(four.left[e], _mm256_blendv_pd(before, there, _mm256_andnot_pd(level, onLeft)));
  keep(four.right[e], _mm256_blendv_pd(there, beyond, _mm256_or_pd(level, onLeft)));
  const __m128 rise = _mm256_cvtpd_ps(dy);
  const __m128 slope = _mm_div_ps(_mm256_cvtpd_ps(_mm256_mul_pd(dx, perStep)), rise);
  _mm_store_ps(four.slope[e], _mm_andnot_ps(_mm_cmpeq_ps(rise, _mm_setzero_ps()), slope));
}

// Writes the first point beyond the triangle as a function of column and row; returns by what that
// may be wrong. x0: corner 0 in columns of the box; across: see slack.
RESECT_AVX2_FMA inline __m256d keepPoints(const Outlines& o, const __m256d (&depths)[3],
                                          const GridLines& lines, const SampleLine& line,
                                          double lineSlack, __m256d x0, __m256d across,
                                          TriangleFour& four) {
  const auto turned = [&](__m256d v) RESECT_AVX2 { return _mm256_xor_pd(v, o.down); };
  const __m256d z = depths[0], dz1 = _mm256_sub_pd(depths[1], z), dz2 = _mm256_sub_pd(depths[2], z);
  const __m256d perPitch = _mm256_set1_pd(1 / line.pitch), scale = _mm256_div_pd(perPitch, o.area);
  const __m256d cyz = _mm256_mul_pd(o.cy, dz1), byz = _mm256_mul_pd(o.by, dz2),
                cxz = _mm256_mul_pd(o.cx, dz1), bxz = _mm256_mul_pd(o.bx, dz2);
  const __m256d perColumn = _mm256_mul_pd(scale, _mm256_set1_pd(1 / lines.linesPerStep));
  const __m256d gx = _mm256_mul_pd(turned(_mm256_sub_pd(cyz, byz)), perColumn);
  keep(four.gx, gx);
  keep(four.gy, _mm256_mul_pd(turned(_mm256_sub_pd(bxz, cxz)), scale));
  const __m256d p0 = _mm256_fnmadd_pd(
      gx, x0,
      _mm256_fmadd_pd(_mm256_sub_pd(z, _mm256_set1_pd(line.first)), perPitch, _mm256_set1_pd(1)));
  const __m256d steep = _mm256_mul_pd(_mm256_add_pd(size(cyz), size(byz)), perColumn);
  const __m256d rise = _mm256_fmadd_pd(
      steep, across,
      _mm256_mul_pd(_mm256_mul_pd(_mm256_add_pd(size(cxz), size(bxz)), o.height), scale));
  const __m256d deep = _mm256_mul_pd(_mm256_add_pd(size(z), _mm256_add_pd(size(dz1), size(dz2))),
                                     _mm256_mul_pd(perPitch, _mm256_set1_pd(1e-14)));
  const __m256d exact = _mm256_fmadd_pd(steep, _mm256_set1_pd(lines.slack), deep);
  const __m256d pointSlack =
      _mm256_fmadd_pd(_mm256_set1_pd(kEightRoundings), _mm256_add_pd(size(p0), rise),
                      _mm256_add_pd(exact, _mm256_set1_pd(lineSlack)));
  keep(four.p0, _mm256_sub_pd(p0, pointSlack));
  keep(four.twoPointSlacks, _mm256_add_pd(pointSlack, pointSlack));
  return pointSlack;
}

// Which of the four can be left to the filter?
RESECT_AVX2 inline unsigned filteredOnes(const Outlines& o, __m256d slack, __m256d pointSlack) {
  const auto isSmall = [](__m256d v) RESECT_AVX2 {
    return _mm256_cmp_pd(v, _mm256_set1_pd(0.2), _CMP_LT_OQ);
  };
  const __m256d least = _mm256_mul_pd(_mm256_mul_pd(o.width, o.height), _mm256_set1_pd(0x1p-20));
  const __m256d sure = _mm256_and_pd(_mm256_and_pd(isSmall(slack), isSmall(pointSlack)),
                                     _mm256_cmp_pd(o.area, least, _CMP_GT_OQ));
  return unsigned(_mm256_movemask_pd(sure));
}

}  // namespace

// Aims at 85 instructions a triangle.
RESECT_AVX2_FMA void prepare(const RoughMesh& placed, const SampleLine& line, double lineSlack,
                             const std::int32_t (&triangles)[4], TriangleFour& four) {
  std::copy_n(triangles, 4, four.triangle);
  const Corners corners = gatherCorners(placed, triangles);
  const Halves from = halvesOf(corners.place[0]);
  keep(four.y0, from.second);
  keep(four.y1, halvesOf(corners.place[1]).second);
  const __m128i firstColumn = keepBoxes(placed, corners.about, four);
  const Outlines o = outlinesOf(corners.place);
  keep(four.leaves,
       _mm_add_epi32(_mm_set1_epi32(1), _mm256_castsi256_si128(_mm256_permutevar8x32_epi32(
                                            _mm256_srai_epi32(_mm256_castpd_si256(o.down), 31),
                                            _mm256_setr_epi32(1, 3, 5, 7, 1, 3, 5, 7)))));

  const GridLines& lines = placed.columns;
  const __m256d perStep = _mm256_set1_pd(lines.linesPerStep);
  const __m256d x0 = _mm256_fmadd_pd(
                    _mm256_cvtepi32_pd(from.first), perStep,
                    _mm256_sub_pd(_mm256_set1_pd(lines.first), _mm256_cvtepi32_pd(firstColumn))),
                x1 = _mm256_fmadd_pd(o.bx, perStep, x0);
  const __m256d across = _mm256_fmadd_pd(o.width, perStep, size(x0));
  const __m256d slack =
      _mm256_fmadd_pd(_mm256_set1_pd(kSixteenRoundings), across, _mm256_set1_pd(lines.slack));
  keep(four.twoSlacks, _mm256_add_pd(slack, slack));
  const auto edge = [&](std::size_t e, __m256d dx, __m256d dy, __m256d end)
                        RESECT_AVX2_FMA { keepEdge(e, dx, dy, end, slack, o.down, perStep, four); };
  edge(0, _mm256_sub_pd(o.cx, o.bx), _mm256_sub_pd(o.cy, o.by), x1);
  edge(1, minus(o.cx), minus(o.cy), x0);
  edge(2, o.bx, o.by, x0);

  const __m256d pointSlack = keepPoints(o, corners.z, lines, line, lineSlack, x0, across, four);
  four.filtered = filteredOnes(o, slack, pointSlack);
}

}  // namespace resect

#endif
