// Most triangles of a fine mesh reach no column of the grid, or a single one: which are they, and
// where does the column cross those that cover it? For collision/grid_hits.cpp alone; the test
// is that of collision/footprint.h, bit for bit.
#pragma once

#include <cstddef>
#include <cstdint>

#include "collision/columns.h"
#include "collision/grid_hits.h"

namespace resect {

// Between which lines of the grid a point lies: the first column and row at or beyond it.
struct GridCell {
  std::int32_t column, row;
};

// A triangle and the only column that it may cover.
struct LoneColumn {
  std::uint32_t triangle;
  GridCell at;
};

struct SortedOut {
  std::size_t lone = 0, others = 0;
};
// Of triangles [begin, end): those that reach one column into `lone`, those that reach more into
// `others`; both have room for all. cells: of the mesh's points. A line at a triangle's lowest
// place may be covered, one at its highest is not (it counts as moved upwards).
SortedOut sortOut(std::span<const Triangle> triangles, const GridCell* cells, std::size_t begin,
                  std::size_t end, LoneColumn* lone, std::uint32_t* others);

// The grid's lines in steps of the mesh's raster.
struct GridRaster {
  const std::int32_t *columns, *rows;
};

struct LoneHit {
  std::int32_t row;
  GridHit hit;
};
// Writes the hits of those that cover their column, in order, and returns where they end; one more
// than `count` may be written. Four at a time on machines with AVX2; the plain one for comparison.
LoneHit* castLone(const SnappedMesh& mesh, const GridRaster& raster, const LoneColumn* lone,
                  std::size_t count, LoneHit* to);
LoneHit* castLonePlainly(const SnappedMesh& mesh, const GridRaster& raster, const LoneColumn* lone,
                         std::size_t count, LoneHit* to);

}  // namespace resect
