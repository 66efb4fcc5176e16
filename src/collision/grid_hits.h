// Which columns of a grid do the triangles of a mesh hit? Gathered row by row, in no order within a
// row: a row's hits stay in the first cache while they are sorted, those of a whole grid do not.
// For collision/grid_columns.cpp and inside_samples_plainly.cpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/raw_array.h"
#include "collision/columns.h"

namespace resect {

struct GridHit {
  std::int32_t column;  // of its row
  std::int32_t sign;    // as of a Crossing
  double depth;
};

// Hits are written without asking first whether they count, and kept by counting them: a branch
// that goes one way as often as the other costs more than a hit.
class RowHits {
 public:
  RowHits() = default;
  // expected: hits that a row has room for from the start.
  RowHits(int rows, std::size_t expected)
      : rows_(std::size_t(rows)), start_(std::size_t(rows) * expected), grown_(rows_.size()) {
    for (std::size_t r = 0; r < rows_.size(); ++r)
      rows_[r] = {start_.data() + r * expected, start_.data() + r * expected,
                  start_.data() + (r + 1) * expected};
  }
  RowHits(RowHits&&) = default;  // rows point into their own arrays: never copied
  RowHits& operator=(RowHits&&) = default;

  // Room for the next hits of a row.
  struct Row {
    GridHit *first, *end, *limit;
  };
  // Rows stay where they are: an inner loop holds on to the first.
  Row* rows() { return rows_.data(); }
  // Where the row's next hits go; `most` of them may be written, and count once row.end is set.
  GridHit* room(Row& row, std::ptrdiff_t most) {
    if (row.limit - row.end < most) [[unlikely]]
      grow(row, std::size_t(most));
    return row.end;
  }

  std::span<const GridHit> operator[](std::size_t row) const {
    return {rows_[row].first, rows_[row].end};
  }

 private:
  [[gnu::noinline]] void grow(Row& row, std::size_t most) {
    const std::span<const GridHit> hits(row.first, row.end);
    RawArray<GridHit> larger(2 * (hits.size() + most));
    std::copy(hits.begin(), hits.end(), larger.begin());
    row = {larger.data(), larger.data() + hits.size(), larger.data() + larger.size()};
    grown_[std::size_t(&row - rows())] = std::move(larger);
  }

  std::vector<Row> rows_;
  RawArray<GridHit> start_;
  std::vector<RawArray<GridHit>> grown_;  // of rows that hold more than expected
};

// Part of the triangles each.
struct GridHits {
  std::vector<RowHits> parts;
  std::vector<std::uint32_t> rowBegins;  // hits of the rows before; at last all: at most 2^32 - 1

  // visit(hit) for those of a row.
  template <typename Visit>
  void forEach(std::size_t row, Visit visit) const {
    for (const RowHits& hits : parts)
      for (const GridHit& hit : hits[row]) visit(hit);
  }
};

// mesh: not empty; grid: with columns.
GridHits gatherHits(const SnappedMesh& mesh, const ColumnGrid& grid);

}  // namespace resect
