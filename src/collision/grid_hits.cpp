// Every triangle looks up the lines of the grid that it may cover.
#include "collision/grid_hits.h"

#include <algorithm>
#include <limits>
#include <memory>

#include "base/assert.h"
#include "base/instruction_set.h"
#include "base/parallel.h"
#include "base/raw_array.h"
#include "collision/column_box.h"
#include "collision/footprint.h"
#include "collision/lone_columns.h"

// Every function that gives such vectors is inlined: how they would be passed does not matter.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace resect {
namespace {

constexpr std::size_t kPart = 1 << 15;  // triangles that one thread takes, at least
constexpr int kWide = 8;                // columns beyond which a triangle's rows are narrowed
constexpr std::size_t kAhead = 8;       // triangles whose depths are on their way while one is cast
constexpr std::size_t kRun = 512;  // of them sorted out at a time: lists stay in the first cache

struct GridLines {
  int count;
  std::vector<std::int32_t> at;  // kBoxStep more than there are
  double linesPerStep, first;

  GridLines(double origin, double pitch, int lines, double meshOrigin, double step)
      : count(lines),
        at(std::size_t(lines + kBoxStep), kAbove),
        linesPerStep(step / pitch),
        first((meshOrigin - origin) / pitch) {
    for (int i = 0; i < count; ++i) at[i] = snapColumn(origin + i * pitch - meshOrigin, step);
  }
  double estimate(double place) const { return first + place * linesPerStep; }
  double slack() const { return 1e-6 + 2 * linesPerStep; }  // that an estimate may be wrong by
  std::int32_t lowerBound(std::int32_t place) const {
    const double about = estimate(place);
    int i = !(about > 0) ? 0 : about < count ? int(about) + 1 : count;
    while (i > 0 && at[i - 1] >= place) --i;
    while (i < count && at[i] < place) ++i;
    return i;
  }
};

typedef double Four __attribute__((vector_size(32)));
typedef std::int32_t FourInts __attribute__((vector_size(16)));

// By estimate, two points at a time: only near a line the lines are asked.
RESECT_WIDEST void findCells(const SnappedMesh::Place* places, std::size_t count,
                             const GridLines& x, const GridLines& y, GridCell* to) {
  const Four first{x.first, y.first, x.first, y.first};
  const Four perStep{x.linesPerStep, y.linesPerStep, x.linesPerStep, y.linesPerStep};
  const Four most{x.count + 0.5, y.count + 0.5, x.count + 0.5, y.count + 0.5};
  const double slack = std::max(x.slack(), y.slack());
  std::size_t i = 0;
  for (; i + 2 <= count; i += 2) {
    FourInts two;
    __builtin_memcpy(&two, places + i, sizeof two);
    Four line = first + __builtin_convertvector(two, Four) * perStep + 1.0;
    line = line > 0.5 ? line : Four{} + 0.5;  // all before the first line are alike,
    line = line < most ? line : most;         // and all behind the last
    const FourInts at = __builtin_convertvector(line, FourInts);
    const Four behind = line - __builtin_convertvector(at, Four);
    const FourInts sure =
        __builtin_convertvector((behind > slack) & (behind < 1 - slack), FourInts);
    __builtin_memcpy(to + i, &at, sizeof at);
    std::uint64_t all[2];
    __builtin_memcpy(all, &sure, sizeof all);
    if ((all[0] & all[1]) == ~std::uint64_t(0)) [[likely]]
      continue;
    for (std::size_t k = i; k < i + 2; ++k)
      to[k] = {x.lowerBound(places[k].x), y.lowerBound(places[k].y)};
  }
  if (i < count) to[i] = {x.lowerBound(places[i].x), y.lowerBound(places[i].y)};
}

// Half-open range of lines between three points.
struct Range {
  std::int32_t first, last;
  static Range round(std::int32_t a, std::int32_t b, std::int32_t c) {
    return {std::min({a, b, c}), std::max({a, b, c})};
  }
  std::int32_t size() const { return last - first; }
};

class GridCaster {
 public:
  GridCaster(const SnappedMesh& mesh, const ColumnGrid& grid)
      : mesh_(mesh),
        linesX_(grid.origin.x(), grid.pitch.x(), grid.countX, mesh.origin.x(), mesh.step),
        linesY_(grid.origin.y(), grid.pitch.y(), grid.countY, mesh.origin.y(), mesh.step),
        cells_(std::make_unique_for_overwrite<GridCell[]>(mesh.places.size())) {
    parallelFor(mesh.places.size(), 1 << 14, [&](std::size_t begin, std::size_t end) {
      findCells(mesh.places.data() + begin, end - begin, linesX_, linesY_, cells_.get() + begin);
    });
  }

  // Adds what triangles [begin, end) hit, at most kRun of them.
  void cast(std::size_t begin, std::size_t end, RowHits& hits) const {
    LoneColumn lone[kRun + 3];
    std::uint64_t others[kRun + 3];
    const SortedOut count = sortOut(mesh_.triangles, cells_.get(), begin, end, lone, others);
    const GridRaster raster{linesX_.at.data(), linesY_.at.data()};
    const std::size_t covering = keepCovering(mesh_, raster, lone, count.lone);
    for (std::size_t k = 0; k < covering; ++k) {
      fetchDepths(lone[std::min(k + kAhead, covering - 1)].triangle);
      castLone(lone[k], raster, hits);
    }
    for (std::size_t k = 0; k < count.others; ++k) castLarge(others[k], raster, hits);
  }

 private:
  std::pair<Range, Range> reach(std::size_t t) const {
    const auto& [ia, ib, ic] = mesh_.triangles[t];
    const GridCell &a = cells_[ia], &b = cells_[ib], &c = cells_[ic];
    return {Range::round(a.column, b.column, c.column), Range::round(a.row, b.row, c.row)};
  }

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
    const auto [columns, rows] = reach(t);
    const Footprint footprint = footprintOf(mesh_, t);
    if (footprint.area == 0) return;
    const auto add = [&](const Range& x, const Range& y) {
      castBox(footprint, raster, {{x.first, y.first}, {x.last, y.last}}, hits);
    };
    if (columns.size() <= kWide) return add(columns, rows);
    // Most of the box round a large triangle is empty: each row is narrowed first.
    for (int y = rows.first; y < rows.last; ++y)
      if (const Range x = narrowed(footprint, footprint.row(linesY_.at[y]), columns); x.size() > 0)
        add(x, Range{y, y + 1});
  }

  // Where the row crosses the edges, by floating point; the exact test decides.
  Range narrowed(const Footprint& footprint, const Footprint::Row& row, const Range& all) const {
    double low = all.first, high = all.last;
    for (int e = 0; e < 3; ++e) {
      const double dy = double(footprint.edge[e].dy);
      if (dy == 0) continue;
      const double at = linesX_.estimate(double(footprint.x0) + double(row.start[e]) / dy);
      if (dy < 0) low = std::max(low, at - linesX_.slack());
      if (dy > 0) high = std::min(high, at + linesX_.slack());
    }
    Range range = all;
    range.first = int(std::min(low, double(all.last)));
    range.last = int(std::max(high, double(all.first))) + 1;
    range.last = std::min(range.last, all.last);
    return range;
  }

  const SnappedMesh& mesh_;
  GridLines linesX_, linesY_;
  std::unique_ptr<GridCell[]> cells_;
};

}  // namespace

GridHits gatherHits(const SnappedMesh& mesh, const ColumnGrid& grid) {
  RESECT_ASSERT(grid.pitch.x() > 0 && grid.pitch.y() > 0);
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
