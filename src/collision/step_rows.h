// Where do the columns of a grid enter and leave a body, gathered in any order and at once sorted?
// For collision/span_caster.cpp and span_samples.cpp, on machines with AVX2.
//
// Each column has its two lowest steps, sorted, in one number of 32 bits: eight columns of a row,
// from any one on, are a vector. A step that comes goes through minima and maxima, so nothing is
// counted and nothing is sorted afterwards. Most columns are crossed twice: the third and fourth
// step lie apart, in memory that is not touched before some column of the row has them, and what a
// column has beyond that in a list. Pairs of 256 x 256 columns stay in the second cache.
#pragma once

#if defined(__x86_64__)
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/raw_array.h"
#include "collision/avx2_integers.h"
#include "collision/lone_columns.h"
#include "collision/sample_steps.h"

namespace resect {

constexpr int kSpan = 8;          // columns of a row that are worked on at once
constexpr Step kNoStep = 0xffff;  // beyond all there are: steps have 15 bits
using StepPair = std::uint32_t;   // the lower step in the lower half
constexpr StepPair kNoSteps = 0xffffffff;

inline Step lowerOf(StepPair pair) { return pair & 0xffff; }
inline Step upperOf(StepPair pair) { return pair >> 16; }
// Puts a step in; returns what drops out.
inline Step insert(StepPair& at, Step s) {
  const StepPair old = at;
  const Step higher = std::max(lowerOf(old), s);
  at = std::min(lowerOf(old), s) | std::min(upperOf(old), higher) << 16;
  return std::max(upperOf(old), higher);
}

class StepRows {
 public:
  struct Row {
    bool deep = false;  // some column has more than two steps: `deepPairs` are in use
    std::vector<std::pair<std::int32_t, Step>> more;  // place and step beyond four, in no order
  };

  // columns, rows > 0, of the grid.
  StepRows(int columns, int rows);

  int columns() const { return columns_; }
  int rowCount() const { return int(rows_.size()); }
  Row& row(int y) { return rows_[std::size_t(y)]; }
  // Of a column. Between rows there is room, for a vector that begins at any of their columns.
  std::int32_t place(int y, int column) const { return y * stride_ + column; }
  GridCell cell(std::int32_t place) const { return {place % stride_, place / stride_}; }
  StepPair* pairs() { return pairs_.data(); }
  // As good as unwritten where the row is not deep.
  StepPair* deepPairs() { return deep_.data(); }

  void insert(std::int32_t place, Step s) {
    const Step dropped = resect::insert(pairs_[std::size_t(place)], s);
    if (dropped != kNoStep) [[unlikely]]
      insertDeep(place, dropped);
  }
  // A third step of a column; or of each of kSpan from this one on, all bits where there is none.
  void insertDeep(std::int32_t place, Step s);
  void insertDeep(std::int32_t place, const Step (&steps)[kSpan]);
  // All that another has of a row.
  void merge(StepRows& other, int y);

 private:
  Row& deepRow(std::int32_t place);

  int columns_;
  std::int32_t stride_;  // from a row's first pair to the next row's
  RawArray<StepPair> pairs_, deep_;
  std::vector<Row> rows_;
};

RESECT_AVX2 inline __m256i load(const StepPair* pairs) {
  return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(pairs));
}
// Puts steps of kSpan columns in, with none as all bits; what drops out is in the upper halves.
RESECT_AVX2 inline __m256i insert(StepPair* pairs, __m256i steps) {
  const __m256i old = load(pairs), higher = _mm256_max_epu16(old, steps);
  const __m256i come = _mm256_or_si256(_mm256_slli_epi32(higher, 16), steps);
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(pairs), _mm256_min_epu16(old, come));
  return _mm256_max_epu16(old, come);
}
RESECT_AVX2 inline bool isNone(__m256i dropped) {
  return _mm256_testc_si256(dropped, _mm256_set1_epi32(std::int32_t(0xffff0000)));
}

}  // namespace resect

#endif
