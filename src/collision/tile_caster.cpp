#include "collision/tile_caster.h"

#if defined(__x86_64__)
#include <algorithm>
#include <cmath>
#include <tuple>

namespace resect {
namespace {

constexpr std::size_t kAhead = 8;  // triangles whose depths are on their way while one is cast
constexpr int kWide = 3;           // tiles beyond which a triangle's rows are narrowed

static_assert(kTileColumns - 1 <= kLinesBeyond && kTileRows - 1 <= kLinesBeyond);

// Eight of a tile each; unit: columns or rows to a tile, lanes: how they are repeated in it.
RawArray<std::int32_t> lanesOf(const GridLines& lines, int unit, bool rows) {
  const int tiles = (lines.count + unit - 1) / unit;
  RawArray<std::int32_t> lanes(std::size_t(tiles) * kLanes);
  for (int tile = 0; tile < tiles; ++tile)
    for (int lane = 0; lane < kLanes; ++lane)
      lanes[std::size_t(tile * kLanes + lane)] =
          lines.at[std::size_t(tile * unit + (rows ? lane / kTileColumns : lane % kTileColumns))];
  return lanes;
}

RESECT_AVX2 inline __m256i lanesAt(const std::int32_t* lanes, int tile) {
  return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(lanes + tile * kLanes));
}
RESECT_AVX2 inline float widest(__m256 rows) {
  return std::max(_mm256_cvtss_f32(rows), _mm_cvtss_f32(_mm256_extractf128_ps(rows, 1)));
}

}  // namespace

TileCaster::TileCaster(const MeshOnGrid& placed, const SampleLine& line)
    : placed_(placed),
      line_(line),
      perPitch_(1 / line.pitch),
      slack_(slackOf(line)),
      highest_(float(line.count) + 0.5f),
      columns_(lanesOf(placed.columns, kTileColumns, false)),
      rows_(lanesOf(placed.rows, kTileRows, true)) {}

inline std::int32_t TileCaster::pointsUpTo(double depth) const {
  const double place = std::clamp((depth - line_.first) * perPitch_ + 1, 0.5, line_.count + 0.5);
  const auto point = std::int32_t(place);
  const double behind = place - point;
  if ((behind > slack_) & (behind < 1 - slack_)) [[likely]]
    return point;
  return line_.upTo(depth);
}

inline void TileCaster::insert(const GridCell& at, double depth, std::int32_t sign,
                               StepTiles& tiles) const {
  tiles.insert(at.row / kTileRows, at.column / kTileColumns,
               at.row % kTileRows * kTileColumns + at.column % kTileColumns,
               TileStep(step(pointsUpTo(depth), sign)));
}

inline void TileCaster::castLone(const LoneColumn& lone, StepTiles& tiles) const {
  const GridRaster raster = placed_.raster();
  const Footprint footprint = footprintOf(placed_.mesh, lone.triangle);
  const auto place = footprint.row(raster.rows[lone.at.row]).place(raster.columns[lone.at.column]);
  insert(lone.at, footprint.depth(place), footprint.sign, tiles);
}

void TileCaster::cast(std::size_t begin, std::size_t end, StepTiles& tiles) const {
  const SnappedMesh& mesh = placed_.mesh;
  LoneColumn lone[kRun + 3];
  std::uint64_t others[kRun + 3];
  const auto fetchDepths = [&](std::size_t triangle) {
    for (const std::int32_t corner : mesh.triangles[triangle])
      __builtin_prefetch(&mesh.points[std::size_t(corner)].z());
  };
  for (; begin < end; begin += kRun) {
    const SortedOut count = sortOut(mesh.triangles, placed_.cells.get(), begin,
                                    std::min(end, begin + kRun), lone, others);
    const std::size_t covering = keepCovering(mesh, placed_.raster(), lone, count.lone);
    for (std::size_t k = 0; k < covering; ++k) {
      const LoneColumn& ahead = lone[std::min(k + kAhead, covering - 1)];
      fetchDepths(ahead.triangle);
      __builtin_prefetch(tiles.pairs(ahead.at.row / kTileRows) + ahead.at.column / kTileColumns, 1);
      castLone(lone[k], tiles);
    }
    TriangleFour four;
    for (std::size_t k = 0; k < count.others; k += 4) {
      for (std::size_t i = k + kAhead; i < std::min(k + kAhead + 4, count.others); ++i)
        fetchDepths(others[i]);
      const std::size_t some = std::min<std::size_t>(4, count.others - k);
      std::fill_n(others + k + some, 4 - some, others[k]);  // the last four may be fewer
      prepare(placed_, line_, slack_, others + k, four);
      for (std::size_t i = 0; i < some; ++i)
        if (four.filtered >> i & 1) [[likely]]
          castFiltered(four, i, others[k + i], tiles);
        else
          castExactly(others[k + i], tiles);
    }
  }
}

void TileCaster::testExactly(std::size_t triangle, int tileRow, int tile, TileStep* steps) const {
  const Footprint footprint = footprintOf(placed_.mesh, triangle);
  for (int lane = 0; lane < kLanes; ++lane) {
    const auto place = footprint.row(rows_[std::size_t(tileRow * kLanes + lane)])
                           .place(columns_[std::size_t(tile * kLanes + lane)]);
    steps[lane] = place.covered()
                      ? TileStep(step(pointsUpTo(footprint.depth(place)), footprint.sign))
                      : kNoStep;
  }
}

void TileCaster::castExactly(std::size_t triangle, StepTiles& tiles) const {
  const Footprint footprint = footprintOf(placed_.mesh, triangle);
  if (footprint.area == 0) return;
  const auto [columns, rows] = placed_.reach(triangle);
  const GridRaster raster = placed_.raster();
  for (int y = rows.first; y < rows.last; ++y) {
    const LineRange range = narrowed(placed_.columns, footprint, raster.rows[y], columns);
    const Footprint::Row row = footprint.row(raster.rows[y]);
    for (int x = range.first; x < range.last; ++x)
      if (const auto place = row.place(raster.columns[x]); place.covered())
        insert({x, y}, footprint.depth(place), footprint.sign, tiles);
  }
}

// Which tiles of a row of them the edges leave, by what the edge functions are at the column of
// corner 0, at most. Single precision tells a place on the raster to 2^-22 of its distance.
std::pair<int, int> TileCaster::tilesLeft(const TriangleFour& four, std::size_t k,
                                          const float (&rows)[3]) const {
  const GridLines& lines = placed_.columns;
  const double from = lines.estimate(four.x0[k]);
  double low = four.left[k] * kTileColumns, high = four.right[k] * kTileColumns + kTileColumns - 1;
  for (int e = 0; e < 3; ++e) {
    // The rows' values are less doubt, and as uncertain.
    const double dy = four.dy[e][k], most = double(rows[e]) + 2 * double(four.doubt[k]);
    if (dy == 0) continue;
    const double away = most / dy * lines.linesPerStep;
    const double slack = lines.slack() + std::abs(away) * 0x1p-22;
    if (dy < 0) low = std::max(low, from + away - slack);
    if (dy > 0) high = std::min(high, from + away + slack);
  }
  return {int(std::min(low / kTileColumns, four.right[k] + 1.0)),
          int(std::max(high / kTileColumns + 1, double(four.left[k]))) - 1};
}

// Aims at 42 instructions a tile, 30 more for a row of them and 60 for a triangle.
RESECT_AVX2_FMA void TileCaster::castFiltered(const TriangleFour& four, std::size_t k,
                                              std::size_t triangle, StepTiles& tiles) const {
  const auto of = [k](const float(&numbers)[4])
                      RESECT_AVX2 { return _mm256_broadcast_ss(numbers + k); };
  const __m256 dy0 = of(four.dy[0]), dy1 = of(four.dy[1]), dy2 = of(four.dy[2]), gx = of(four.gx),
               doubt = of(four.doubt), twoDoubts = _mm256_add_ps(doubt, doubt),
               twoSlacks = of(four.twoSlacks);
  const __m256 lowest = _mm256_set1_ps(0.5f), highest = _mm256_set1_ps(highest_);
  const __m256i x0 = _mm256_set1_epi32(four.x0[k]), leaves = _mm256_set1_epi32(four.leaves[k]);
  const std::ptrdiff_t across = tiles.across();
  int left = four.left[k], right = four.right[k];
  const bool wide = right - left >= kWide;
  const int top = four.top[k];
  StepPairs* pairs = tiles.pairs(four.bottom[k]);
  for (int tileRow = four.bottom[k]; tileRow <= top; ++tileRow, pairs += across) {
    const __m256 y = _mm256_cvtepi32_ps(
        _mm256_sub_epi32(lanesAt(rows_.data(), tileRow), _mm256_set1_epi32(four.y0[k])));
    const __m256 row0 = _mm256_fmadd_ps(of(four.dx[0]), y, of(four.start0)),
                 row1 = _mm256_fmsub_ps(of(four.dx[1]), y, of(four.doubt)),
                 row2 = _mm256_fmsub_ps(of(four.dx[2]), y, of(four.doubt)),
                 rowP = _mm256_fmadd_ps(of(four.gy), y, of(four.p0));
    if (wide)
      std::tie(left, right) = tilesLeft(four, k, {widest(row0), widest(row1), widest(row2)});
    for (int tile = left; tile <= right; ++tile) {
      const __m256 x = _mm256_cvtepi32_ps(_mm256_sub_epi32(lanesAt(columns_.data(), tile), x0));
      const __m256 v0 = _mm256_fnmadd_ps(dy0, x, row0), v1 = _mm256_fnmadd_ps(dy1, x, row1),
                   v2 = _mm256_fnmadd_ps(dy2, x, row2);
      const __m256 least = _mm256_min_ps(v0, _mm256_min_ps(v1, v2));
      const __m256 p = _mm256_min_ps(_mm256_max_ps(_mm256_fmadd_ps(gx, x, rowP), lowest), highest);
      const __m256i point = _mm256_cvttps_epi32(p);
      // Sign bits: in doubt; on both sides of a point.
      const __m256 open = _mm256_xor_ps(_mm256_add_ps(least, twoDoubts), least);
      const __m256 astride = _mm256_castsi256_ps(
          _mm256_sub_epi32(point, _mm256_cvttps_epi32(_mm256_add_ps(p, twoSlacks))));
      const __m256 unsure = _mm256_or_ps(open, _mm256_andnot_ps(least, astride));
      const __m256i crossing = _mm256_or_si256(_mm256_slli_epi32(point, 1), leaves);
      const __m256i all = _mm256_castps_si256(_mm256_blendv_ps(
          _mm256_castsi256_ps(crossing), _mm256_castsi256_ps(_mm256_set1_epi32(-1)), least));
      __m128i steps =
          _mm_packs_epi32(_mm256_castsi256_si128(all), _mm256_extracti128_si256(all, 1));
      alignas(16) TileStep apart[kLanes];
      if (!_mm256_testz_ps(unsure, unsure)) [[unlikely]] {
        testExactly(triangle, tileRow, tile, apart);
        steps = load(apart);
      }
      const __m128i dropped = resect::insert(pairs[tile], steps);
      if (!areNone(dropped)) [[unlikely]] {
        store(apart, dropped);
        tiles.insertDeep(tileRow, tile, apart);
      }
    }
  }
}

}  // namespace resect

#endif
