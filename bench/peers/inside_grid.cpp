#include "peers/inside_grid.h"

#include <algorithm>

namespace resect::bench {
namespace {

SampleLine lineOf(const InsideGrid& grid) { return {grid.first.z(), grid.pitch.z(), grid.n}; }

}  // namespace

InsideGrid gridRound(const TriangleMesh& mesh, int n) {
  const Aabb box = bounds(mesh);
  const Vec3 pitch = box.size() / n;
  return {box.min + 0.5 * pitch, pitch, n};
}

Crossings castColumns(const TriangleMesh& mesh, const InsideGrid& grid) {
  return castColumns(snapToRaster(mesh),
                     ColumnGrid{grid.first.head<2>(), grid.pitch.head<2>(), grid.n, grid.n});
}

std::int64_t countInside(const TriangleMesh& mesh, const InsideGrid& grid) {
  const Crossings columns = castColumns(mesh, grid);
  std::int64_t inside = 0;
  for (std::size_t c = 0; c < columns.columnCount(); ++c)
    forEachInside(columns[c], lineOf(grid), [&](int first, int end) { inside += end - first; });
  return inside;
}

std::vector<std::uint8_t> flagsOf(const Crossings& columns, const InsideGrid& grid) {
  const auto n = std::size_t(grid.n);
  std::vector<std::uint8_t> flags(n * n * n, 0);
  for (std::size_t c = 0; c < columns.columnCount(); ++c)
    forEachInside(columns[c], lineOf(grid), [&](int first, int end) {
      std::fill_n(flags.begin() + std::ptrdiff_t(n * c) + first, end - first, std::uint8_t(1));
    });
  return flags;
}

FlagDifference compareFlags(const TriangleMesh& mesh, const InsideGrid& grid,
                            const std::vector<std::uint8_t>& ours,
                            const std::vector<std::uint8_t>& theirs, double tolerance) {
  FlagDifference difference;
  // A point is off the surface when all six places `tolerance` from it are on the side that we say.
  std::vector<Vec3> around;
  std::vector<std::uint8_t> side;
  for (int y = 0; y < grid.n; ++y)
    for (int x = 0; x < grid.n; ++x)
      for (int z = 0; z < grid.n; ++z) {
        const std::size_t i = grid.index(x, y, z);
        if (ours[i] == theirs[i]) continue;
        ++difference.points;
        for (int d = 0; d < 6; ++d)
          around.push_back(grid.point(x, y, z) + (d & 1 ? 1 : -1) * tolerance * Vec3::Unit(d / 2));
        side.push_back(ours[i]);
      }
  if (around.empty()) return difference;
  const std::vector<std::int32_t> winding = windingNumbers(snapToRaster(mesh), around);
  for (std::size_t i = 0; i < side.size(); ++i) {
    bool same = true;
    for (int d = 0; d < 6; ++d) same = same && (winding[6 * i + d] > 0) == (side[i] != 0);
    difference.offSurface += same;
  }
  return difference;
}

std::int64_t oddColumns(const Crossings& columns) {
  std::int64_t odd = 0;
  for (std::size_t c = 0; c < columns.columnCount(); ++c) odd += columns[c].size() % 2;
  return odd;
}

}  // namespace resect::bench
