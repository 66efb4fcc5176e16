// Between which lines of a grid do the points of a mesh lie? For collision/grid_hits.cpp and
// rough_mesh.h.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "collision/columns.h"
#include "collision/footprint.h"
#include "collision/lone_columns.h"

namespace resect {

constexpr int kLinesBeyond = 8;  // that are known behind a grid's last: what reads some may go on

// The columns or the rows of a grid, as lines of the raster.
struct GridLines {
  int count;
  std::vector<std::int32_t> at;  // kLinesBeyond more than there are
  double linesPerStep, first;
  double slack;  // that an estimate may be wrong by: rounding to the raster, and of large numbers

  GridLines(double origin, double pitch, int lines, double meshOrigin, double step);
  double estimate(double place) const { return first + place * linesPerStep; }
  // The first line at `place` or beyond.
  std::int32_t lowerBound(std::int32_t place) const;
};

// Half-open range of lines between three points.
struct LineRange {
  std::int32_t first, last;
  static LineRange round(std::int32_t a, std::int32_t b, std::int32_t c) {
    return {std::min({a, b, c}), std::max({a, b, c})};
  }
  std::int32_t size() const { return last - first; }
};

// Where a row at `y` of the raster crosses the triangle's edges, by floating point: columns of
// `all` that are left out lie beside it, of the others the exact test decides.
LineRange narrowed(const GridLines& columns, const Footprint& footprint, std::int32_t y,
                   const LineRange& all);

// A grid on a mesh's raster; both the mesh and what it refers to must live longer.
struct GridOnMesh {
  const SnappedMesh& mesh;
  GridLines columns, rows;

  GridOnMesh(const SnappedMesh& mesh, const ColumnGrid& grid);
  GridRaster raster() const { return {columns.at.data(), rows.at.data()}; }
};

struct MeshOnGrid : GridOnMesh {
  std::unique_ptr<GridCell[]> cells;  // of the mesh's points

  MeshOnGrid(const SnappedMesh& mesh, const ColumnGrid& grid);
  // Columns and rows that a triangle may cover.
  std::pair<LineRange, LineRange> reach(std::size_t triangle) const;
};

}  // namespace resect
