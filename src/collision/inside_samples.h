// Which of a grid's points lie inside a closed body? Column by column, as stretches of points.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/raw_array.h"
#include "collision/columns.h"

namespace resect {

// Points along a column, in ascending order: point i stands at first + i * pitch.
struct SampleLine {
  double first, pitch;  // m; pitch > 0
  std::int32_t count;   // >= 0

  double at(std::int32_t i) const { return first + i * pitch; }
  // How many of them stand at `depth` (finite) or below.
  std::int32_t upTo(double depth) const;
};

// Points [first, last) of a column lie inside; first < last.
struct InsideStretch {
  std::int32_t first, last;
  bool operator==(const InsideStretch&) const = default;
};

// The stretches of column (i, j), upwards; they do not touch each other.
struct InsideSamples {
  std::size_t countX = 0;
  std::vector<std::uint32_t> offsets;  // per row: countX + 1
  RawArray<InsideStretch> all;         // with room left between rows

  std::span<const InsideStretch> column(std::size_t i, std::size_t j) const {
    const std::uint32_t* at = offsets.data() + j * (countX + 1) + i;
    return {all.data() + at[0], all.data() + at[1]};
  }
};

// A point is inside where more shells are entered than left below it, as forEachInside() has it for
// columns whose signs sum to zero: those of a closed mesh.
// Cost: as castColumns() or less: a crossing is kept as the points that it lies between.
InsideSamples insideSamples(const SnappedMesh& mesh, const ColumnGrid& grid,
                            const SampleLine& line);
// The same without spans of columns (collision/span_samples.h), as on machines without AVX2.
InsideSamples insideSamplesPlainly(const SnappedMesh& mesh, const ColumnGrid& grid,
                                   const SampleLine& line);

}  // namespace resect
