#include "collision/inside_samples.h"

#include <cmath>

#include "collision/tiled_samples.h"

namespace resect {

std::int32_t SampleLine::upTo(double depth) const {
  auto i = std::int32_t(std::clamp(std::floor((depth - first) / pitch) + 1, 0.0, double(count)));
  while (i > 0 && at(i - 1) > depth) --i;
  while (i < count && at(i) <= depth) ++i;
  return i;
}

namespace {

// Columns up to which tiles are taken: each thread has all of them, 4 bytes a column.
constexpr std::size_t kFewColumns = std::size_t(1) << 25;

// Tiles of four columns and two rows reach beyond a grid's ends.
std::size_t columnsInTiles(const ColumnGrid& grid) {
  return (std::size_t(grid.countX) + 3) / 4 * 4 * ((std::size_t(grid.countY) + 1) / 2 * 2);
}

}  // namespace

InsideSamples insideSamples(const SnappedMesh& mesh, const ColumnGrid& grid,
                            const SampleLine& line) {
  const bool tiled = canTile() && line.count <= kMostPoints && columnsInTiles(grid) <= kFewColumns;
  if (!tiled || grid.count() == 0 || mesh.places.empty())
    return insideSamplesPlainly(mesh, grid, line);
  return insideSamplesByTiles(mesh, grid, line);
}

}  // namespace resect
