#include "collision/inside_samples.h"

#include <cmath>

#include "collision/span_samples.h"

namespace resect {

std::int32_t SampleLine::upTo(double depth) const {
  auto i = std::int32_t(std::clamp(std::floor((depth - first) / pitch) + 1, 0.0, double(count)));
  while (i > 0 && at(i - 1) > depth) --i;
  while (i < count && at(i) <= depth) ++i;
  return i;
}

namespace {

constexpr std::size_t kFewTriangles = std::size_t(1) << 31;  // their numbers take 32 bits
// Columns up to which spans are taken: up to four threads have all of them each, 4 bytes a column,
// and as much again where some are crossed more than twice.
constexpr std::size_t kFewColumns = std::size_t(1) << 25;

// Rows are held as whole vectors and one more.
std::size_t columnsHeld(const ColumnGrid& grid) {
  return (std::size_t(grid.countX) / 8 + 2) * 8 * std::size_t(grid.countY);
}

}  // namespace

InsideSamples insideSamples(const SnappedMesh& mesh, const ColumnGrid& grid,
                            const SampleLine& line) {
  const bool bySpans = canFindSpans() && line.count <= kMostPoints &&
                       columnsHeld(grid) <= kFewColumns && mesh.triangles.size() < kFewTriangles;
  if (!bySpans || grid.count() == 0 || mesh.places.empty())
    return insideSamplesPlainly(mesh, grid, line);
  return insideSamplesBySpans(mesh, grid, line);
}

}  // namespace resect
