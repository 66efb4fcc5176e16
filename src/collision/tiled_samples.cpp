#include "collision/tiled_samples.h"

#include "base/assert.h"

#if defined(__x86_64__)
#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <memory>
#include <mutex>

#include "base/parallel.h"
#include "collision/step_tiles.h"
#include "collision/tile_caster.h"

namespace resect {
namespace {

constexpr std::size_t kShared =
    1 << 22;  // columns of all threads' tiles that there may be at least

// Each thread that casts triangles has tiles of its own: as many as ever work at once.
class TilesOfThreads {
 public:
  TilesOfThreads(int columns, int rows) : columns_(columns), rows_(rows) {}

  // Calls work(tiles).
  template <typename Work>
  void lend(const Work& work) {
    StepTiles* tiles = nullptr;
    {
      const std::lock_guard lock(mutex_);
      if (!idle_.empty()) {
        tiles = idle_.back();
        idle_.pop_back();
      }
    }
    if (!tiles) {
      auto made = std::make_unique<StepTiles>(columns_, rows_);
      const std::lock_guard lock(mutex_);
      tiles = all_.emplace_back(std::move(made)).get();
    }
    work(*tiles);
    const std::lock_guard lock(mutex_);
    idle_.push_back(tiles);
  }

  std::vector<std::unique_ptr<StepTiles>>& all() { return all_; }

 private:
  int columns_, rows_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<StepTiles>> all_;
  std::vector<StepTiles*> idle_;
};

// How many of the lanes up to each one are in the set.
constexpr std::array<std::array<std::uint32_t, 4>, 16> kCounts = [] {
  std::array<std::array<std::uint32_t, 4>, 16> counts{};
  for (unsigned set = 0; set < 16; ++set)
    for (unsigned lane = 0; lane < 4; ++lane)
      counts[set][lane] = std::uint32_t(std::popcount(set & ((2u << lane) - 1)));
  return counts;
}();

// Where the stretches of a row of the grid go.
struct RowEnd {
  InsideStretch* to;       // behind the last
  std::uint32_t* offsets;  // of the next column, whose own is known
};

// Turns the steps of a row of tiles into stretches.
class StretchWriter {
 public:
  StretchWriter(StepTiles& tiles, int columns, InsideStretch* all)
      : tiles_(tiles), columns_(columns), all_(all) {}

  void write(int tileRow, RowEnd (&rows)[kTileRows], int rowCount) const;

 private:
  void writeTwo(const StepPairs& pair, RowEnd& low, RowEnd& high) const;
  void writeFour(const StepPairs& pair, const StepPairs& deep, RowEnd& low, RowEnd& high) const;
  void writeLanes(int tileRow, int tile, int row, int count, RowEnd& to) const;

  StepTiles& tiles_;
  int columns_;
  InsideStretch* all_;
};

// Columns with at most two steps: a stretch where the first enters, the second leaves, and a point
// lies between them. Aims at 45 instructions.
RESECT_AVX2 [[gnu::always_inline]] inline void StretchWriter::writeTwo(const StepPairs& pair,
                                                                       RowEnd& low,
                                                                       RowEnd& high) const {
  const __m256i lower = _mm256_cvtepu16_epi32(load(pair.lower)),
                upper = _mm256_cvtepu16_epi32(load(pair.upper));
  const __m256i first = _mm256_srli_epi32(lower, 1), last = _mm256_srli_epi32(upper, 1);
  const __m256i lone = _mm256_cmpeq_epi32(upper, _mm256_set1_epi32(kNoStep));
  const __m256i through = _mm256_slli_epi32(_mm256_andnot_si256(lower, upper), 31);
  const __m256i some =
      _mm256_andnot_si256(lone, _mm256_and_si256(through, _mm256_cmpgt_epi32(last, first)));
  const auto set = unsigned(_mm256_movemask_ps(_mm256_castsi256_ps(some)));
  const __m256i even = _mm256_unpacklo_epi32(first, last), odd = _mm256_unpackhi_epi32(first, last);
  const auto put = [&](RowEnd & row, __m256i stretches, unsigned of)
      __attribute__((target("avx2"), always_inline)) {
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(row.to), packed(stretches, of));
    const __m128i counts = _mm_load_si128(reinterpret_cast<const __m128i*>(kCounts[of].data()));
    const __m128i before = _mm_set1_epi32(std::int32_t(row.to - all_));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(row.offsets), _mm_add_epi32(before, counts));
    row.to += kCounts[of][3];
    row.offsets += kTileColumns;
  };
  put(low, _mm256_permute2x128_si256(even, odd, 0x20), set & 0xf);
  put(high, _mm256_permute2x128_si256(even, odd, 0x31), set >> 4);
}

// Do the two steps of every column enter and leave, or are there none?
RESECT_AVX2 inline bool goThrough(const StepPairs& pair) {
  const __m128i lower = load(pair.lower), upper = load(pair.upper), odd = _mm_set1_epi16(1);
  const auto isNone = [](__m128i steps)
                          RESECT_AVX2 { return _mm_cmpeq_epi16(steps, _mm_set1_epi16(-1)); };
  // The lower one leaves, or is alone; the upper one enters.
  const __m128i first = _mm_or_si128(_mm_and_si128(lower, odd), isNone(upper));
  const __m128i wrong =
      _mm_or_si128(_mm_andnot_si128(isNone(lower), first), _mm_andnot_si128(upper, odd));
  return _mm_testz_si128(wrong, wrong);
}

// Columns that go in and out at most twice: what is sorted so has a point between the two. Aims at
// 12 instructions a column.
RESECT_AVX2 [[gnu::always_inline]] inline void StretchWriter::writeFour(const StepPairs& pair,
                                                                        const StepPairs& deep,
                                                                        RowEnd& low,
                                                                        RowEnd& high) const {
  const auto put = [&](RowEnd & row, int first) __attribute__((target("avx2"), always_inline)) {
    for (int lane = first; lane < first + kTileColumns; ++lane) {
      const auto add = [&](TileStep enters, TileStep leaves) __attribute__((always_inline)) {
        *row.to = {enters >> 1, leaves >> 1};
        row.to += enters >> 1 < leaves >> 1;
      };
      add(pair.lower[lane], pair.upper[lane]);
      add(deep.lower[lane], deep.upper[lane]);
      *row.offsets++ = std::uint32_t(row.to - all_);
    }
  };
  put(low, 0);
  put(high, kTileColumns);
}

// Any columns, of one row of a tile.
void StretchWriter::writeLanes(int tileRow, int tile, int row, int count, RowEnd& to) const {
  StepTiles::Row& all = tiles_.row(tileRow);
  const StepPairs& pair = tiles_.pairs(tileRow)[tile];
  std::vector<TileStep> many;
  for (int column = 0; column < count; ++column) {
    const int lane = row * kTileColumns + column;
    TileStep steps[4] = {pair.lower[lane], pair.upper[lane], kNoStep, kNoStep};
    if (all.deep) {
      const StepPairs& deep = tiles_.deepPairs(tileRow)[tile];
      steps[2] = deep.lower[lane];
      steps[3] = deep.upper[lane];
    }
    const auto number = std::uint32_t(tile * kLanes + lane);
    auto more = all.more.end();
    if (steps[3] != kNoStep)
      more = std::lower_bound(all.more.begin(), all.more.end(), std::pair(number, TileStep(0)));
    if (more != all.more.end() && more->first == number) {
      many.assign(steps, steps + 4);
      for (; more != all.more.end() && more->first == number; ++more) many.push_back(more->second);
      to.to = writeStretches<TileStep>(many, to.to);
    } else {
      to.to = writeStretches<TileStep>({steps, std::find(steps, steps + 4, kNoStep)}, to.to);
    }
    *to.offsets++ = std::uint32_t(to.to - all_);
  }
}

RESECT_AVX2 void StretchWriter::write(int tileRow, RowEnd (&rows)[kTileRows], int rowCount) const {
  StepTiles::Row& all = tiles_.row(tileRow);
  std::sort(all.more.begin(), all.more.end());
  const StepPairs *const pairs = tiles_.pairs(tileRow), *const deep = tiles_.deepPairs(tileRow);
  RowEnd low = rows[0], high = rows[1];  // of their own, so that they stay in registers
  for (int tile = 0; tile < tiles_.across(); ++tile) {
    const int count = std::min(kTileColumns, columns_ - tile * kTileColumns);
    const bool two = !all.deep || areNone(load(deep[tile].lower));
    const bool whole = count == kTileColumns && rowCount == kTileRows;
    if (two && whole) [[likely]] {
      writeTwo(pairs[tile], low, high);
    } else if (whole && all.more.empty() && goThrough(pairs[tile]) && goThrough(deep[tile])) {
      writeFour(pairs[tile], deep[tile], low, high);
    } else {
      rows[0] = low, rows[1] = high;
      for (int row = 0; row < rowCount; ++row) writeLanes(tileRow, tile, row, count, rows[row]);
      low = rows[0], high = rows[1];
    }
  }
}

// Stretches that the columns of a row of the grid can have together, and as many more as are
// written beside them.
std::size_t roomOf(StepTiles& tiles, int tileRow) {
  const StepTiles::Row& row = tiles.row(tileRow);
  return std::size_t(tiles.across()) * kTileColumns * (row.deep ? 2 : 1) + row.more.size() / 2;
}

}  // namespace

bool canTile() {
  static const bool can = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  return can;
}

InsideSamples insideSamplesByTiles(const SnappedMesh& mesh, const ColumnGrid& grid,
                                   const SampleLine& line) {
  InsideSamples inside;
  inside.countX = std::size_t(grid.countX);
  inside.offsets.resize((inside.countX + 1) * std::size_t(grid.countY));

  const MeshOnGrid placed(mesh, grid);
  const TileCaster caster(placed, line);
  TilesOfThreads lent(grid.countX, grid.countY);
  // A thread's tiles take 4 bytes a column, deep ones as much again.
  const std::size_t most = std::max<std::size_t>(4, kShared / grid.count());
  const std::size_t share =
      threadsAllowed() <= most ? 1 : (mesh.triangles.size() + most - 1) / most;
  parallelFor(mesh.triangles.size(), std::max(4 * TileCaster::kRun, share),
              [&](std::size_t begin, std::size_t end) {
                lent.lend([&](StepTiles& tiles) { caster.cast(begin, end, tiles); });
              });
  if (lent.all().empty()) return inside;  // no triangles
  StepTiles& tiles = *lent.all().front();
  const auto rows = std::size_t(tiles.rowCount());
  if (lent.all().size() > 1)
    parallelFor(rows, 8, [&](std::size_t begin, std::size_t end) {
      for (std::size_t row = begin; row < end; ++row)
        for (std::size_t k = 1; k < lent.all().size(); ++k) tiles.merge(*lent.all()[k], int(row));
    });

  std::vector<std::size_t> begins(std::size_t(grid.countY) + 1, 0);
  for (std::size_t row = 0; row < std::size_t(grid.countY); ++row)
    begins[row + 1] = begins[row] + roomOf(tiles, int(row) / kTileRows);
  RESECT_ASSERT(begins.back() <= std::numeric_limits<std::uint32_t>::max());
  inside.all.resize(begins.back());
  const StretchWriter writer(tiles, grid.countX, inside.all.data());
  parallelFor(rows, 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t tileRow = begin; tileRow < end; ++tileRow) {
      const std::size_t first = tileRow * kTileRows;
      const int count = int(std::min<std::size_t>(kTileRows, std::size_t(grid.countY) - first));
      RowEnd ends[kTileRows] = {};
      for (std::size_t k = 0; k < std::size_t(count); ++k) {
        std::uint32_t* const offsets = inside.offsets.data() + (first + k) * (inside.countX + 1);
        offsets[0] = std::uint32_t(begins[first + k]);
        ends[k] = {inside.all.data() + begins[first + k], offsets + 1};
      }
      writer.write(int(tileRow), ends, count);
    }
  });
  return inside;
}

}  // namespace resect

#else

namespace resect {

bool canTile() { return false; }

InsideSamples insideSamplesByTiles(const SnappedMesh& mesh, const ColumnGrid& grid,
                                   const SampleLine& line) {
  return insideSamplesPlainly(mesh, grid, line);
}

}  // namespace resect

#endif
