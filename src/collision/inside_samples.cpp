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

// Columns beyond which tiles would have room for more stretches than can be numbered.
constexpr std::size_t kFewColumns = std::size_t(1) << 30;

}  // namespace

InsideSamples insideSamples(const SnappedMesh& mesh, const ColumnGrid& grid,
                            const SampleLine& line) {
  const bool tiled = canTile() && line.count <= kMostPoints && grid.count() <= kFewColumns;
  if (!tiled || grid.count() == 0 || mesh.places.empty())
    return insideSamplesPlainly(mesh, grid, line);
  return insideSamplesByTiles(mesh, grid, line);
}

}  // namespace resect
