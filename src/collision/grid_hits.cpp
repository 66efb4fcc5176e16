// Every triangle looks up the lines of the grid that it may cover.
#include "collision/grid_hits.h"

#include <algorithm>
#include <limits>

#include "base/assert.h"
#include "base/parallel.h"
#include "base/raw_array.h"
#include "collision/column_box.h"
#include "collision/footprint.h"
#include "collision/grid_lines.h"
#include "collision/lone_columns.h"

namespace resect {
namespace {

static_assert(kBoxStep <= kLinesBeyond);

constexpr std::size_t kPart = 1 << 15;  // triangles that one thread takes, at least
constexpr int kWide = 8;                // columns beyond which a triangle's rows are narrowed
constexpr std::size_t kAhead = 8;       // triangles whose depths are on their way while one is cast
constexpr std::size_t kRun = 512;  // of them sorted out at a time: lists stay in the first cache

class GridCaster {
 public:
  GridCaster(const SnappedMesh& mesh, const ColumnGrid& grid) : mesh_(mesh), placed_(mesh, grid) {}

  // Adds what triangles [begin, end) hit, at most kRun of them.
  void cast(std::size_t begin, std::size_t end, RowHits& hits) const {
    LoneColumn lone[kRun + 3];
    std::uint64_t others[kRun + 3];
    const SortedOut count = sortOut(mesh_.triangles, placed_.cells.get(), begin, end, lone, others);
    const GridRaster raster = placed_.raster();
    const std::size_t covering = keepCovering(mesh_, raster, lone, count.lone);
    for (std::size_t k = 0; k < covering; ++k) {
      fetchDepths(lone[std::min(k + kAhead, covering - 1)].triangle);
      castLone(lone[k], raster, hits);
    }
    for (std::size_t k = 0; k < count.others; ++k) castLarge(others[k], raster, hits);
  }

 private:
  void fetchDepths(std::size_t triangle) const {
    for (const std::int32_t corner : mesh_.triangles[triangle])
      __builtin_prefetch(&mesh_.points[std::size_t(corner)].z());
  }
  void castLone(const LoneColumn& lone, const GridRaster& raster, RowHits& hits) const {
    const auto& [column, rowOfGrid] = lone.at;
    const Footprint footprint = footprintOf(mesh_, lone.triangle);
    const auto place = footprint.row(raster.rows[rowOfGrid]).place(raster.columns[column]);
    RowHits::Row& row = hits.rows()[rowOfGrid];
    *hits.room(row, 1) = {column, footprint.sign, footprint.depth(place)};
    ++row.end;
  }

  void castLarge(std::size_t t, const GridRaster& raster, RowHits& hits) const {
    const auto [columns, rows] = placed_.reach(t);
    const Footprint footprint = footprintOf(mesh_, t);
    if (footprint.area == 0) return;
    const auto add = [&](const LineRange& x, const LineRange& y) {
      castBox(footprint, raster, {{x.first, y.first}, {x.last, y.last}}, hits);
    };
    if (columns.size() <= kWide) return add(columns, rows);
    // Most of the box round a large triangle is empty: each row is narrowed first.
    for (int y = rows.first; y < rows.last; ++y)
      if (const LineRange x = narrowed(placed_.columns, footprint, raster.rows[y], columns);
          x.size() > 0)
        add(x, LineRange{y, y + 1});
  }

  const SnappedMesh& mesh_;
  MeshOnGrid placed_;
};

}  // namespace

GridHits gatherHits(const SnappedMesh& mesh, const ColumnGrid& grid) {
  // The fewer the parts, the closer together lies what a row holds: one thread makes one. However
  // many there are, a row's hits come in the same order.
  const std::size_t wanted = threadsAllowed() > 1 ? 2 * threadsAllowed() : 1;
  const std::size_t share = std::max(kPart, (mesh.triangles.size() + wanted - 1) / wanted);
  const std::size_t part = (share + kRun - 1) / kRun * kRun;
  const std::size_t parts = (mesh.triangles.size() + part - 1) / part;
  GridHits result{std::vector<RowHits>(parts), {}};
  const GridCaster caster(mesh, grid);
  // A guess that saves copying, as if every column went in and out: what is not needed is not
  // touched.
  const std::size_t expected = 2 * std::size_t(grid.countX) / std::max<std::size_t>(parts, 1) + 64;
  parallelFor(mesh.triangles.size(), part, [&](std::size_t begin, std::size_t end) {
    RowHits& hits = result.parts[begin / part] = RowHits(grid.countY, expected);
    for (std::size_t t = begin; t < end; t += kRun) caster.cast(t, std::min(end, t + kRun), hits);
  });
  std::size_t sum = 0;
  for (std::size_t row = 0; row < std::size_t(grid.countY); ++row) {
    result.rowBegins.push_back(std::uint32_t(sum));
    for (const RowHits& hits : result.parts) sum += hits[row].size();
    RESECT_ASSERT(sum <= std::numeric_limits<std::uint32_t>::max());
  }
  result.rowBegins.push_back(std::uint32_t(sum));
  return result;
}

}  // namespace resect
