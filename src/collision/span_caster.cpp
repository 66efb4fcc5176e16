#include "collision/span_caster.h"

#if defined(__x86_64__)
#include <algorithm>
#include <bit>
#include <utility>

#include "collision/avx2_floats.h"

namespace resect {
namespace {

constexpr int kRowsAtOnce = 8;

static_assert(kRowsAtOnce <= kLinesBeyond);

RESECT_AVX2 inline __m256 allOf(const float (&numbers)[4], std::size_t k) {
  return _mm256_broadcast_ss(numbers + k);
}
RESECT_AVX2 inline __m256 countUp() { return _mm256_setr_ps(0, 1, 2, 3, 4, 5, 6, 7); }

// What a triangle covers of kRowsAtOnce rows, at the end of the list. y: of the rows, in steps of
// the raster; places: of column firstColumn in each. Returns a bit for each row of which an end is
// in doubt. Aims at 60 instructions.
RESECT_AVX2_FMA inline unsigned findSpans(const TriangleFour& four, std::size_t k,
                                          const std::int32_t* lines, __m256i places,
                                          SpanList& list) {
  const __m256i y = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(lines));
  const auto from = [&](const std::int32_t(&corner)[4]) RESECT_AVX2 {
    return _mm256_cvtepi32_ps(_mm256_sub_epi32(y, _mm256_set1_epi32(corner[k])));
  };
  const __m256 y0 = from(four.y0), y1 = from(four.y1);
  const auto at = [&](const float(&ends)[3][4], std::size_t e) RESECT_AVX2_FMA {
    return _mm256_fmadd_ps(allOf(four.slope[e], k), e == 0 ? y1 : y0, allOf(ends[e], k));
  };
  const __m256 left = _mm256_max_ps(at(four.left, 0),
                                    _mm256_max_ps(at(four.left, 1), at(four.left, 2))),
               right = _mm256_min_ps(at(four.right, 0),
                                     _mm256_min_ps(at(four.right, 1), at(four.right, 2)));
  const __m256 twoSlacks = allOf(four.twoSlacks, k);
  const __m256 first = roundedUp(left), last = roundedUp(right);
  const __m256 unsure =
      _mm256_or_ps(_mm256_cmp_ps(first, roundedUp(_mm256_add_ps(left, twoSlacks)), _CMP_NEQ_UQ),
                   _mm256_cmp_ps(last, roundedUp(_mm256_add_ps(right, twoSlacks)), _CMP_NEQ_UQ));
  const __m256 box = allOf(four.columns, k), gx = allOf(four.gx, k);
  const __m256 begin = _mm256_min_ps(_mm256_max_ps(first, _mm256_setzero_ps()), box);
  const int to = list.count;
  put(list.place + to, _mm256_add_epi32(places, _mm256_cvtps_epi32(begin)));
  put(list.columns + to, _mm256_sub_ps(_mm256_min_ps(last, box), begin));
  put(list.point + to,
      _mm256_fmadd_ps(gx, begin, _mm256_fmadd_ps(allOf(four.gy, k), y0, allOf(four.p0, k))));
  put(list.gx + to, gx);
  put(list.twoSlacks + to, allOf(four.twoPointSlacks, k));
  put(list.leaves + to, _mm256_set1_epi32(four.leaves[k]));
  put(list.triangle + to, _mm256_set1_epi32(four.triangle[k]));
  return unsigned(_mm256_movemask_ps(unsure));
}

}  // namespace

SpanCaster::SpanCaster(const RoughMesh& placed, const SampleLine& line)
    : placed_(placed),
      line_(line),
      perPitch_(1 / line.pitch),
      slack_(slackOf(line)),
      highest_(float(line.count) + 0.5f) {}

void SpanCaster::cast(std::size_t begin, std::size_t end, StepRows& rows) const {
  SortedRun run;
  for (; begin < end; begin += kRun) {
    sortOutRoughly(placed_, begin, std::min(end, begin + kRun), run);
    castLone(run, rows);
    castLarger(run, rows);
  }
}

void SpanCaster::castLone(const SortedRun& run, StepRows& rows) const {
  Step steps[SortedRun::kRoom];
  findSteps(placed_, line_, slack_, run, steps);
  for (std::size_t k = 0; k < run.lone; ++k)
    if (steps[k] != kNoStep) [[likely]]
      rows.insert(rows.place(run.row[k], run.column[k]), steps[k]);
    else
      castExactly(run.triangle[k], rows);
  for (std::size_t k = 0; k < run.unsure; ++k) castExactly(run.doubtful[k], rows);
}

// Four from different places: what a triangle has written is in the cache before the next one
// beside it reads it again in other vectors.
void SpanCaster::castLarger(const SortedRun& run, StepRows& rows) const {
  TriangleFour four;
  SpanList list;
  const std::size_t quarter = (run.others + 3) / 4;
  for (std::size_t k = 0; k < quarter; ++k) {
    std::int32_t triangles[4];
    for (std::size_t i = 0; i < 4; ++i)
      triangles[i] = run.larger[std::min(k + i * quarter, run.others - 1)];
    prepare(placed_, line_, slack_, triangles, four);
    for (std::size_t i = 0; i < 4 && k + i * quarter < run.others; ++i)
      if (four.filtered >> i & 1) [[likely]]
        listSpans(four, i, list, rows);
      else
        castExactly(triangles[i], rows);
  }
  castListed(list, rows);
}

inline std::int32_t SpanCaster::pointsUpTo(double depth) const {
  const double place = std::clamp((depth - line_.first) * perPitch_ + 1, 0.5, line_.count + 0.5);
  const auto point = std::int32_t(place);
  const double behind = place - point;
  if ((behind > slack_) & (behind < 1 - slack_)) [[likely]]
    return point;
  return line_.upTo(depth);
}

void SpanCaster::castRowExactly(std::int32_t triangle, int y, StepRows& rows) const {
  const Footprint footprint = footprintOf(placed_.mesh, std::size_t(triangle));
  const GridRaster raster = placed_.raster();
  const LineRange range = narrowed(placed_.columns, footprint, raster.rows[y],
                                   placed_.reach(std::size_t(triangle)).first);
  const Footprint::Row row = footprint.row(raster.rows[y]);
  for (int x = range.first; x < range.last; ++x)
    if (const auto place = row.place(raster.columns[x]); place.covered())
      rows.insert(rows.place(y, x), step(pointsUpTo(footprint.depth(place)), footprint.sign));
}

void SpanCaster::castExactly(std::int32_t triangle, StepRows& rows) const {
  if (footprintOf(placed_.mesh, std::size_t(triangle)).area == 0) return;
  const LineRange reached = placed_.reach(std::size_t(triangle)).second;
  for (int y = reached.first; y < reached.last; ++y) castRowExactly(triangle, y, rows);
}

void SpanCaster::stepsExactly(const SpanList& list, int k, GridCell first,
                              Step (&steps)[kSpan]) const {
  const Footprint footprint = footprintOf(placed_.mesh, std::size_t(list.triangle[k]));
  const GridRaster raster = placed_.raster();
  const Footprint::Row row = footprint.row(raster.rows[first.row]);
  for (int c = 0; c < std::min(kSpan, int(list.columns[k])); ++c)
    steps[c] = step(pointsUpTo(footprint.depth(row.place(raster.columns[first.column + c]))),
                    footprint.sign);
}

// Not inlined: a loop round it would have every address in it worked out before, and not enough
// registers for them.
RESECT_AVX2_FMA [[gnu::noinline]] void SpanCaster::listRows(const TriangleFour& four, std::size_t k,
                                                            int y, SpanList& list,
                                                            StepRows& rows) const {
  const int some = std::min(kRowsAtOnce, four.lastRow[k] - y);
  const __m256i across = _mm256_mullo_epi32(_mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7),
                                            _mm256_set1_epi32(rows.place(1, 0)));
  const __m256i places =
      _mm256_add_epi32(across, _mm256_set1_epi32(rows.place(y, four.firstColumn[k])));
  unsigned unsure =
      findSpans(four, k, placed_.rows.at.data() + y, places, list) & ((1u << some) - 1);
  if (unsure != 0) [[unlikely]]
    for (; unsure != 0; unsure &= unsure - 1) {
      const int row = std::countr_zero(unsure);
      castRowExactly(four.triangle[k], y + row, rows);
      list.columns[list.count + row] = 0;
    }
  list.count += some;
  if (four.columns[k] > kSpan) listRest(list, some, rows);
}

void SpanCaster::listSpans(const TriangleFour& four, std::size_t k, SpanList& list,
                           StepRows& rows) const {
  for (int y = four.firstRow[k]; y < four.lastRow[k]; y += kRowsAtOnce) {
    if (list.count > SpanList::kRoom - kRowsAtOnce) castListed(list, rows);
    listRows(four, k, y, list, rows);
  }
}

// What the last spans of the list have beyond kSpan columns.
void SpanCaster::listRest(SpanList& list, int some, StepRows& rows) const {
  const int first = list.count - some;
  const float gx = list.gx[first], twoSlacks = list.twoSlacks[first];
  const std::int32_t leaves = list.leaves[first], triangle = list.triangle[first];
  std::int32_t places[kRowsAtOnce];
  float columns[kRowsAtOnce], points[kRowsAtOnce];
  std::copy_n(list.place + first, some, places);
  std::copy_n(list.columns + first, some, columns);
  std::copy_n(list.point + first, some, points);
  for (int row = 0; row < some; ++row)
    for (int done = kSpan; float(done) < columns[row]; done += kSpan) {
      if (list.count == SpanList::kRoom) castListed(list, rows);
      const int to = list.count++;
      list.place[to] = places[row] + done;
      list.columns[to] = columns[row] - float(done);
      list.point[to] = points[row] + gx * float(done);
      list.gx[to] = gx;
      list.twoSlacks[to] = twoSlacks;
      list.leaves[to] = leaves;
      list.triangle[to] = triangle;
    }
}

// Aims at 36 instructions for eight columns of a row.
RESECT_AVX2_FMA void SpanCaster::castListed(SpanList& list, StepRows& rows) const {
  const __m256 lowest = _mm256_set1_ps(0.5f), highest = _mm256_set1_ps(highest_), x = countUp();
  StepPair* const pairs = rows.pairs();
  alignas(32) StepPair dropped[SpanList::kRoom][kSpan];
  std::int32_t places[SpanList::kRoom];
  std::size_t dropping = 0;
  const int count = std::exchange(list.count, 0);
  for (int k = 0; k < count; ++k) {
    const __m256i out =
        _mm256_castps_si256(_mm256_cmp_ps(x, _mm256_broadcast_ss(list.columns + k), _CMP_GE_OQ));
    const __m256 place =
        _mm256_fmadd_ps(_mm256_broadcast_ss(list.gx + k), x, _mm256_broadcast_ss(list.point + k));
    const __m256 p = _mm256_min_ps(_mm256_max_ps(place, lowest), highest);
    const __m256i point = _mm256_cvttps_epi32(p);
    const __m256i astride = _mm256_sub_epi32(
        point, _mm256_cvttps_epi32(_mm256_add_ps(p, _mm256_broadcast_ss(list.twoSlacks + k))));
    __m256i steps = _mm256_or_si256(
        _mm256_or_si256(_mm256_slli_epi32(point, 1), _mm256_set1_epi32(list.leaves[k])), out);
    if (!_mm256_testc_si256(out, astride)) [[unlikely]] {
      Step apart[kSpan];
      _mm256_storeu_si256(reinterpret_cast<__m256i*>(apart), steps);
      stepsExactly(list, k, rows.cell(list.place[k]), apart);
      steps = load(apart);
    }
    const __m256i third = insert(pairs + list.place[k], steps);
    _mm256_store_si256(reinterpret_cast<__m256i*>(dropped[dropping]), third);
    places[dropping] = list.place[k];
    dropping += !isNone(third);
  }
  for (std::size_t k = 0; k < dropping; ++k) {
    Step steps[kSpan];
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(steps), _mm256_srai_epi32(load(dropped[k]), 16));
    rows.insertDeep(places[k], steps);
  }
}

}  // namespace resect

#endif
