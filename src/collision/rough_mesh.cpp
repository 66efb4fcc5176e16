#include "collision/rough_mesh.h"

#if defined(__x86_64__)
#include <immintrin.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/instruction_set.h"
#include "base/parallel.h"

namespace resect {
namespace {

constexpr int kMostLines = 1 << 15;
constexpr float kMostSlack = 0.1f;

// A number next to a line, or on it, moved to the side of the line where the point lies.
float besideLine(float about, std::int32_t place, const GridLines& lines) {
  const float line = std::round(about);
  if (line < 0 || line >= float(lines.count)) return about;  // there is no line
  if (place <= lines.at[std::size_t(line)]) return std::min(about, line);
  constexpr float least = std::numeric_limits<float>::min();  // a smaller one may count as zero
  return std::max({about, least, std::nextafter(line, std::numeric_limits<float>::infinity())});
}

RoughPoint exactly(const GridOnMesh& grid, SnappedMesh::Place place) {
  return {besideLine(float(grid.columns.estimate(place.x)), place.x, grid.columns),
          besideLine(float(grid.rows.estimate(place.y)), place.y, grid.rows)};
}

// Aims at 5 instructions a point.
RESECT_AVX2_FMA void findPoints(const GridOnMesh& grid, float slack, std::size_t begin,
                                std::size_t end, RoughPoint* points) {
  const SnappedMesh::Place* const places = grid.mesh.places.data();
  const __m256d first = _mm256_setr_pd(grid.columns.first, grid.rows.first, grid.columns.first,
                                       grid.rows.first),
                perStep = _mm256_setr_pd(grid.columns.linesPerStep, grid.rows.linesPerStep,
                                         grid.columns.linesPerStep, grid.rows.linesPerStep);
  const __m256 slacks = _mm256_set1_ps(slack), noSign = _mm256_set1_ps(-0.0f);
  const auto two = [&](std::size_t i) RESECT_AVX2_FMA {
    const __m128i at = _mm_loadu_si128(reinterpret_cast<const __m128i*>(places + i));
    return _mm256_cvtpd_ps(_mm256_fmadd_pd(_mm256_cvtepi32_pd(at), perStep, first));
  };
  std::size_t i = begin;
  for (; i + 4 <= end; i += 4) {
    const __m256 four = _mm256_set_m128(two(i + 2), two(i));
    const __m256 line = _mm256_round_ps(four, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
    const __m256 away = _mm256_andnot_ps(noSign, _mm256_sub_ps(four, line));
    const __m256 near = _mm256_cmp_ps(away, slacks, _CMP_LE_OQ);
    _mm256_storeu_ps(&points[i].column, four);
    if (!_mm256_testz_ps(near, near)) [[unlikely]]
      for (std::size_t k = i; k < i + 4; ++k) points[k] = exactly(grid, places[k]);
  }
  for (; i < end; ++i) points[i] = exactly(grid, places[i]);
}

// What is worked out in double precision, rounded.
float roundedSlack(const GridOnMesh& grid) {
  const auto of = [](const GridLines& l) { return float(l.slack + 0x1p-24 * l.count); };
  return std::max(of(grid.columns), of(grid.rows));
}

}  // namespace

bool RoughMesh::isEnough(const GridOnMesh& grid) {
  return std::max(grid.columns.count, grid.rows.count) <= kMostLines &&
         roundedSlack(grid) <= kMostSlack;
}

RoughMesh::RoughMesh(GridOnMesh grid)
    : GridOnMesh(std::move(grid)),
      points(std::make_unique_for_overwrite<RoughPoint[]>(mesh.places.size())) {
  const float near = roundedSlack(*this);
  slack = 2.5f * near;  // what is moved: from one side of the line to the other, and a rounding
  parallelFor(mesh.places.size(), 1 << 14, [&](std::size_t begin, std::size_t end) {
    findPoints(*this, near, begin, end, points.get());
  });
}

std::pair<LineRange, LineRange> RoughMesh::reach(std::size_t triangle) const {
  const auto& [ia, ib, ic] = mesh.triangles[triangle];
  const RoughPoint &a = points[std::size_t(ia)], &b = points[std::size_t(ib)],
                   &c = points[std::size_t(ic)];
  const auto range = [](const GridLines& lines, float a, float b, float c) {
    const auto line = [&](float place) {
      return std::int32_t(std::clamp(std::ceil(place), 0.0f, float(lines.count)));
    };
    return LineRange{line(std::min({a, b, c})), line(std::max({a, b, c}))};
  };
  return {range(columns, a.column, b.column, c.column), range(rows, a.row, b.row, c.row)};
}

}  // namespace resect

#endif
