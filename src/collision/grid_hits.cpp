// Every triangle looks up the lines of the grid that it may cover.
#include "collision/grid_hits.h"

#include <algorithm>
#include <limits>
#include <memory>

#include "base/assert.h"
#include "base/parallel.h"
#include "base/raw_array.h"
#include "collision/column_box.h"
#include "collision/footprint.h"
#include "collision/lone_columns.h"

namespace resect {
namespace {

constexpr std::size_t kPart = 1 << 15;  // triangles whose hits one thread gathers
constexpr int kWide = 8;                // columns from which on a triangle's rows are narrowed
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
  std::int32_t lowerBound(std::int32_t place) const {
    const double about = estimate(place);
    int i = !(about > 0) ? 0 : about < count ? int(about) + 1 : count;
    while (i > 0 && at[i - 1] >= place) --i;
    while (i < count && at[i] < place) ++i;
    return i;
  }
};

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
        slack_(1e-6 + 2 * linesX_.linesPerStep),
        cells_(std::make_unique_for_overwrite<GridCell[]>(mesh.points.size())) {
    parallelFor(mesh.points.size(), 1 << 14,
                [&](std::size_t begin, std::size_t end) { findCells(begin, end); });
  }

  // Adds what triangles [begin, end) hit, at most kRun of them.
  void cast(std::size_t begin, std::size_t end, RowHits& hits) const {
    LoneColumn lone[kRun];
    std::uint32_t others[kRun];
    const SortedOut count = sortOut(mesh_.triangles, cells_.get(), begin, end, lone, others);
    const GridRaster raster{linesX_.at.data(), linesY_.at.data()};
    LoneHit found[kRun + 1];
    const LoneHit* const last = castLone(mesh_, raster, lone, count.lone, found);
    for (const LoneHit* h = found; h != last; ++h) {
      RowHits::Row& row = hits.rows()[h->row];
      *hits.room(row, 1) = h->hit;
      ++row.end;
    }
    for (std::size_t k = 0; k < count.others; ++k) castLarge(others[k], raster, hits);
  }

 private:
  // By estimate, which is out by less than the slack: only near a line the lines are asked.
  void findCells(std::size_t begin, std::size_t end) {
    const Pair first{linesX_.first, linesY_.first};
    const Pair perStep{linesX_.linesPerStep, linesY_.linesPerStep};
    const Pair most{linesX_.count + 0.5, linesY_.count + 0.5};
    const double slack = std::max(slack_, 1e-6 + 2 * linesY_.linesPerStep);
    for (std::size_t i = begin; i < end; ++i) {
      const SnappedMesh::Point& p = mesh_.points[i];
      Pair line = first + Pair{double(p.x), double(p.y)} * perStep + 1.0;
      line = line > 0.5 ? line : Pair{0.5, 0.5};  // all before the first line are alike,
      line = line < most ? line : most;           // and all behind the last
      const IntPair at = __builtin_convertvector(line, IntPair);
      const Pair behind = line - __builtin_convertvector(at, Pair);
      const auto sure = (behind > slack) & (behind < 1 - slack);
      cells_[i] = {at[0], at[1]};
      if (!(sure[0] & sure[1])) cells_[i] = {linesX_.lowerBound(p.x), linesY_.lowerBound(p.y)};
    }
  }

  std::pair<Range, Range> reach(std::size_t t) const {
    const auto& [ia, ib, ic] = mesh_.triangles[t];
    const GridCell &a = cells_[ia], &b = cells_[ib], &c = cells_[ic];
    return {Range::round(a.column, b.column, c.column), Range::round(a.row, b.row, c.row)};
  }
  Footprint footprintOf(std::size_t t) const {
    const auto& [a, b, c] = mesh_.triangles[t];
    return Footprint(mesh_.points[a], mesh_.points[b], mesh_.points[c]);
  }

  void castLarge(std::size_t t, const GridRaster& raster, RowHits& hits) const {
    const auto [columns, rows] = reach(t);
    const Footprint footprint = footprintOf(t);
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
      if (dy < 0) low = std::max(low, at - slack_);
      if (dy > 0) high = std::min(high, at + slack_);
    }
    Range range = all;
    range.first = int(std::min(low, double(all.last)));
    range.last = int(std::max(high, double(all.first))) + 1;
    range.last = std::min(range.last, all.last);
    return range;
  }

  const SnappedMesh& mesh_;
  GridLines linesX_, linesY_;
  double slack_;  // columns that an estimate may be wrong by
  std::unique_ptr<GridCell[]> cells_;
};

}  // namespace

GridHits gatherHits(const SnappedMesh& mesh, const ColumnGrid& grid) {
  RESECT_ASSERT(grid.pitch.x() > 0 && grid.pitch.y() > 0);
  const std::size_t parts = (mesh.triangles.size() + kPart - 1) / kPart;
  GridHits result{std::vector<RowHits>(parts, RowHits(0, 0)), {}};
  const GridCaster caster(mesh, grid);
  // A guess that saves copying, as if every column went in and out: what is not needed is not
  // touched.
  const std::size_t expected = 2 * std::size_t(grid.countX) / std::max<std::size_t>(parts, 1) + 64;
  parallelFor(mesh.triangles.size(), kPart, [&](std::size_t begin, std::size_t end) {
    RowHits& hits = result.parts[begin / kPart] = RowHits(grid.countY, expected);
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
