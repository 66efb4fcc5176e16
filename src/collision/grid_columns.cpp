// The crossings of a regular grid's columns: each row's hits, sorted.
#include <utility>

#include "base/parallel.h"
#include "collision/column_order.h"
#include "collision/columns.h"
#include "collision/grid_hits.h"

namespace resect {
namespace {

// Counting sort of a row's hits into its columns. end: of each column, 0 until now; gets where in
// `all` the column ends.
void sortRow(const GridHits& hits, std::size_t row, std::span<std::uint32_t> end, Crossing* all) {
  // end[c] counts, then is where column c goes on, and at last where it ends.
  hits.forEach(row, [&](const GridHit& hit) { ++end[std::size_t(hit.column)]; });
  std::uint32_t sum = hits.rowBegins[row];
  for (std::uint32_t& e : end) e = std::exchange(sum, sum + e);
  hits.forEach(row, [&](const GridHit& hit) {
    all[end[std::size_t(hit.column)]++] = {hit.depth, hit.sign};
  });
  std::uint32_t begin = hits.rowBegins[row];
  for (const std::uint32_t e : end) {
    if (e - begin > 1) sortColumn(all + begin, all + e);
    begin = e;
  }
}

}  // namespace

Crossings castColumns(const SnappedMesh& mesh, const ColumnGrid& grid) {
  Crossings result;
  result.offsets.assign(grid.count() + 1, 0);
  if (grid.count() == 0 || mesh.places.empty()) return result;
  const GridHits hits = gatherHits(mesh, grid);
  result.all.resize(hits.rowBegins.back());
  const auto columns = std::size_t(grid.countX);
  parallelFor(std::size_t(grid.countY), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
      sortRow(hits, row, std::span(result.offsets).subspan(row * columns + 1, columns),
              result.all.data());
  });
  return result;
}

}  // namespace resect
