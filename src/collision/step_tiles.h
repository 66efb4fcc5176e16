// Where do the columns of a grid enter and leave a body, gathered in any order and at once sorted?
// For collision/tile_caster.cpp and tiled_samples.cpp, on machines with AVX2.
//
// A tile is four columns of two rows: the lanes of a vector. It holds the lowest steps of each of
// its columns, sorted; a step that comes goes through a network of minima and maxima, so nothing is
// counted, nothing is sorted afterwards, and what one triangle writes the next reads in the same
// vectors. Most columns are crossed twice: the first two steps lie side by side, the third and
// fourth apart, in memory that is not touched before some column of its row of tiles has them, and
// what a column has beyond that in a list. Steps take 16 bits, so that the tiles of 256 x 256
// columns stay in the second cache.
#pragma once

#if defined(__x86_64__)
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/raw_array.h"
#include "collision/avx2_integers.h"
#include "collision/sample_steps.h"

namespace resect {

constexpr int kTileColumns = 4, kTileRows = 2, kLanes = kTileColumns * kTileRows;
using TileStep = std::uint16_t;
constexpr TileStep kNoStep = 0xffff;  // beyond all there are

// Two steps of each column; lane (row % 2) * 4 + column % 4.
struct alignas(32) StepPairs {
  TileStep lower[kLanes], upper[kLanes];
};

class StepTiles {
 public:
  struct Row {
    bool deep = false;  // some column has more than two steps: `deepPairs` are in use
    // Lane of the row of tiles (tile * 8 + lane) and step, in no order: those beyond four.
    std::vector<std::pair<std::uint32_t, TileStep>> more;
  };

  // columns, rows > 0, of the grid.
  StepTiles(int columns, int rows);

  int across() const { return across_; }
  int rowCount() const { return int(rows_.size()); }
  Row& row(int tileRow) { return rows_[std::size_t(tileRow)]; }
  // The first tile of a row of tiles; deep ones are as good as unwritten where the row is not deep.
  StepPairs* pairs(int tileRow) { return pairs_.data() + std::ptrdiff_t(tileRow) * across_; }
  StepPairs* deepPairs(int tileRow) { return deep_.data() + std::ptrdiff_t(tileRow) * across_; }

  // Of a lane of a row of tiles.
  void insert(int tileRow, int tile, int lane, TileStep s) {
    StepPairs& at = pairs(tileRow)[tile];
    const TileStep higher = std::max(at.lower[lane], s);
    at.lower[lane] = std::min(at.lower[lane], s);
    const TileStep highest = std::max(at.upper[lane], higher);
    at.upper[lane] = std::min(at.upper[lane], higher);
    if (highest != kNoStep) [[unlikely]] {
      StepPairs third;
      std::fill_n(third.lower, kLanes, kNoStep);
      third.lower[lane] = highest;
      insertDeep(tileRow, tile, third.lower);
    }
  }
  // One step for each lane, or none.
  void insertDeep(int tileRow, int tile, const TileStep* steps);
  // All that another has of a row of tiles.
  void merge(StepTiles& other, int tileRow);

 private:
  int across_;
  RawArray<StepPairs> pairs_, deep_;
  std::vector<Row> rows_;
};

RESECT_AVX2 inline __m128i load(const TileStep* lanes) {
  return _mm_load_si128(reinterpret_cast<const __m128i*>(lanes));
}
RESECT_AVX2 inline void store(TileStep* lanes, __m128i v) {
  _mm_store_si128(reinterpret_cast<__m128i*>(lanes), v);
}
RESECT_AVX2 inline bool areNone(__m128i steps) { return _mm_test_all_ones(steps); }
// What drops out of a pair when a step is put in.
RESECT_AVX2 inline __m128i insert(StepPairs& at, __m128i steps) {
  const __m128i lower = load(at.lower), upper = load(at.upper);
  const __m128i higher = _mm_max_epu16(lower, steps);
  store(at.lower, _mm_min_epu16(lower, steps));
  store(at.upper, _mm_min_epu16(upper, higher));
  return _mm_max_epu16(upper, higher);
}

}  // namespace resect

#endif
