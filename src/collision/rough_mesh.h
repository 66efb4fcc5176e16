// Where do a mesh's points lie between the columns and rows of a grid, in single precision? For
// collision/span_caster.cpp, lone_points.cpp and triangle_fours.cpp, on machines with AVX2 and
// fused products.
#pragma once

#if defined(__x86_64__)
#include <cstddef>
#include <memory>
#include <utility>

#include "collision/grid_lines.h"

namespace resect {

// Counted in columns and rows. Rounded up, and put between 0 and as many as there are, each is the
// first line at the point or beyond it, exactly: what is so near to a line that this is in doubt is
// moved to the side where it lies.
struct RoughPoint {
  float column, row;
};

struct RoughMesh : GridOnMesh {
  std::unique_ptr<RoughPoint[]> points;
  float slack;  // lines that a number between the grid's ends may be wrong by

  // Whether single precision will do: for no more lines, and no finer ones, than it tells.
  static bool isEnough(const GridOnMesh& grid);
  // Where it is.
  explicit RoughMesh(GridOnMesh grid);
  // Columns and rows that a triangle may cover.
  std::pair<LineRange, LineRange> reach(std::size_t triangle) const;
};

}  // namespace resect

#endif
