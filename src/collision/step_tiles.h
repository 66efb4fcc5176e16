// Where do the columns of a grid enter and leave a body, gathered in any order and at once sorted?
// For collision/tile_caster.cpp and tiled_samples.cpp, on machines with AVX2.
//
// A tile is four columns of two rows: the lanes of a vector. It holds the lowest steps of each of
// its columns, sorted; a step that comes goes through a network of minima and maxima, so nothing is
// counted, nothing is sorted afterwards, and what one triangle writes the next reads in the same
// vectors. Most columns are crossed twice: the first two steps lie in one line of the cache, the
// third and fourth apart, in memory that is not touched before some column of its row of tiles has
// them, and what a column has beyond that in a list.
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
constexpr Step kNoStep = ~Step(0);  // beyond all there are

// Two steps of each column; lane (row % 2) * 4 + column % 4.
struct alignas(64) StepPairs {
  Step lower[kLanes], upper[kLanes];
};

class StepTiles {
 public:
  struct Row {
    bool deep = false;  // some column has more than two steps: `deepPairs` are in use
    // Lane of the row of tiles (tile * 8 + lane) and step, in no order: those beyond four.
    std::vector<std::pair<std::uint32_t, Step>> more;
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
  void insert(int tileRow, int tile, int lane, Step s) {
    StepPairs& at = pairs(tileRow)[tile];
    const Step higher = std::max(at.lower[lane], s);
    at.lower[lane] = std::min(at.lower[lane], s);
    const Step highest = std::max(at.upper[lane], higher);
    at.upper[lane] = std::min(at.upper[lane], higher);
    if (highest != kNoStep) [[unlikely]] {
      StepPairs third;
      std::fill_n(third.lower, kLanes, kNoStep);
      third.lower[lane] = highest;
      insertDeep(tileRow, tile, third.lower);
    }
  }
  // One step for each lane, or none.
  void insertDeep(int tileRow, int tile, const Step* steps);
  // All that another has of a row of tiles.
  void merge(StepTiles& other, int tileRow);

 private:
  int across_;
  RawArray<StepPairs> pairs_, deep_;
  std::vector<Row> rows_;
};

RESECT_AVX2 inline __m256i load(const Step* lanes) {
  return _mm256_load_si256(reinterpret_cast<const __m256i*>(lanes));
}
RESECT_AVX2 inline void store(Step* lanes, __m256i v) {
  _mm256_store_si256(reinterpret_cast<__m256i*>(lanes), v);
}
RESECT_AVX2 inline bool areNone(__m256i steps) {
  return _mm256_testc_si256(steps, _mm256_set1_epi32(-1));
}
// What drops out of a pair when a step is put in.
RESECT_AVX2 inline __m256i insert(StepPairs& at, __m256i steps) {
  const __m256i lower = load(at.lower), upper = load(at.upper);
  const __m256i higher = _mm256_max_epu32(lower, steps);
  store(at.lower, _mm256_min_epu32(lower, steps));
  store(at.upper, _mm256_min_epu32(upper, higher));
  return _mm256_max_epu32(upper, higher);
}

}  // namespace resect

#endif
