// Most triangles of a fine mesh reach no column of the grid, or a single one: which are they, and
// which of those does it cross? For collision/grid_hits.cpp alone; the test is
// that of collision/footprint.h.
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
  std::uint64_t triangle;
  GridCell at;
};

struct SortedOut {
  std::size_t lone = 0, others = 0;
};
// Of triangles [begin, end): those that reach one column into `lone`, those that reach more into
// `others`; both have room for all, and three more. cells: of the mesh's points. A line at a
// triangle's lowest place may be covered, one at its highest is not (it counts as moved upwards).
// Four at a time on machines with AVX2; the plain one for comparison.
SortedOut sortOut(std::span<const Triangle> triangles, const GridCell* cells, std::size_t begin,
                  std::size_t end, LoneColumn* lone, std::uint64_t* others);
SortedOut sortOutPlainly(std::span<const Triangle> triangles, const GridCell* cells,
                         std::size_t begin, std::size_t end, LoneColumn* lone,
                         std::uint64_t* others);

// The grid's lines in steps of the mesh's raster.
struct GridRaster {
  const std::int32_t *columns, *rows;
};

// Keeps those that cover their column, in order, and returns how many. Four at a time on machines
// with AVX2; the plain one for comparison.
std::size_t keepCovering(const SnappedMesh& mesh, const GridRaster& raster, LoneColumn* lone,
                         std::size_t count);
std::size_t keepCoveringPlainly(const SnappedMesh& mesh, const GridRaster& raster, LoneColumn* lone,
                                std::size_t count);

}  // namespace resect
