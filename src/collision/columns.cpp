#include "collision/columns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.h"
#include "base/parallel.h"
#include "collision/footprint.h"

namespace resect {
namespace {

constexpr std::size_t kPart = 1024;  // triangles that one thread takes at a time

// A point's cell among the columns; and a half-open range of cells between points.
struct Cell {
  std::int32_t x, y;
};
struct Reach {
  std::int32_t firstX, endX, firstY, endY;
  bool empty() const { return (firstX >= endX) | (firstY >= endY); }
};

// The columns of a grid. A point's cell: the first column and row at or beyond it.
class GridColumns {
 public:
  GridColumns(const SnappedMesh& mesh, const ColumnGrid& grid)
      : x_(mesh.origin.x(), mesh.step, grid.origin.x(), grid.pitch.x(), grid.countX),
        y_(mesh.origin.y(), mesh.step, grid.origin.y(), grid.pitch.y(), grid.countY) {}

  Cell cell(const SnappedMesh::RasterXY& p) const {
    return {x_.lowerBound(p.x), y_.lowerBound(p.y)};
  }
  // A line at a triangle's lowest coordinate may be covered; one at its highest, shifted by e, is
  // not.
  Reach between(const Cell& low, const Cell& high) const { return {low.x, high.x, low.y, high.y}; }
  // visit(column, x, y)
  template <typename Visit>
  void visit(const Reach& reach, Visit&& visit) const {
    for (std::int32_t j = reach.firstY; j < reach.endY; ++j)
      for (std::int32_t i = reach.firstX; i < reach.endX; ++i)
        visit(std::uint32_t(j) * std::uint32_t(x_.at.size()) + std::uint32_t(i),
              x_.at[std::size_t(i)], y_.at[std::size_t(j)]);
  }

 private:
  // Lines of the grid on the raster, in ascending order.
  struct Lines {
    std::vector<std::int32_t> at;
    double perStep, offset;

    Lines(double meshOrigin, double step, double origin, double pitch, int count)
        : at(std::size_t(count)), perStep(step / pitch), offset((meshOrigin - origin) / pitch + 1) {
      for (int i = 0; i < count; ++i)
        at[std::size_t(i)] = snapColumn(origin + i * pitch - meshOrigin, step);
    }
    // Estimated first, then corrected exactly.
    std::int32_t lowerBound(std::int32_t coordinate) const {
      const auto count = std::int32_t(at.size());
      auto i = std::int32_t(std::clamp(offset + coordinate * perStep, 0.0, double(count)));
      while (i > 0 && at[std::size_t(i - 1)] >= coordinate) --i;
      while (i < count && at[std::size_t(i)] < coordinate) ++i;
      return i;
    }
  };
  Lines x_, y_;
};

// Columns at given positions, sorted into the cells of a coarse grid.
class ListedColumns {
 public:
  // position(i): x, y of column i, m. Columns beside the mesh are left out.
  template <typename Position>
  ListedColumns(const SnappedMesh& mesh, std::size_t count, Position&& position) {
    std::vector<Entry> entries;
    entries.reserve(count);
    SnappedMesh::RasterXY high{kBelow, kBelow};
    for (std::size_t i = 0; i < count; ++i) {
      const Vec2 p = position(i);
      const std::int32_t x = snapColumn(p.x() - mesh.origin.x(), mesh.step);
      const std::int32_t y = snapColumn(p.y() - mesh.origin.y(), mesh.step);
      if (x == kBelow || x == kAbove || y == kBelow || y == kAbove) continue;
      entries.push_back({x, y, std::uint32_t(i)});
      low_ = {std::min(low_.x, x), std::min(low_.y, y)};
      high = {std::max(high.x, x), std::max(high.y, y)};
    }
    side_ = int(std::clamp(std::sqrt(double(entries.size()) / 2), 1.0, 1024.0));
    perStepX_ = side_ / (double(high.x) - low_.x + 1);
    perStepY_ = side_ / (double(high.y) - low_.y + 1);
    offsets_.assign(std::size_t(side_) * std::size_t(side_) + 1, 0);
    const auto cellOf = [&](const Entry& e) {
      return std::size_t(cellY(e.y)) * std::size_t(side_) + std::size_t(cellX(e.x));
    };
    for (const Entry& e : entries) ++offsets_[cellOf(e) + 1];
    for (std::size_t c = 1; c < offsets_.size(); ++c) offsets_[c] += offsets_[c - 1];
    entries_.resize(entries.size());
    std::vector<std::uint32_t> cursor(offsets_.begin(), offsets_.end() - 1);
    for (const Entry& e : entries) entries_[cursor[cellOf(e)]++] = e;
  }

  Cell cell(const SnappedMesh::RasterXY& p) const { return {cellX(p.x), cellY(p.y)}; }
  Reach between(const Cell& low, const Cell& high) const {
    return {std::max(low.x, 0), std::min(high.x + 1, side_), std::max(low.y, 0),
            std::min(high.y + 1, side_)};
  }
  template <typename Visit>
  void visit(const Reach& reach, Visit&& visit) const {
    for (std::int32_t j = reach.firstY; j < reach.endY; ++j) {
      const std::uint32_t* const row = offsets_.data() + std::size_t(j) * std::size_t(side_);
      for (std::uint32_t e = row[reach.firstX]; e < row[reach.endX]; ++e)
        visit(entries_[e].column, entries_[e].x, entries_[e].y);
    }
  }

 private:
  struct Entry {
    std::int32_t x, y;
    std::uint32_t column;
  };
  // -1 below the columns, side_ above. Rounding only has to be monotonic.
  std::int32_t cellX(std::int32_t x) const { return cell((double(x) - low_.x) * perStepX_); }
  std::int32_t cellY(std::int32_t y) const { return cell((double(y) - low_.y) * perStepY_); }
  std::int32_t cell(double at) const {
    return std::int32_t(std::clamp(at + 1, 0.0, side_ + 1.0)) - 1;
  }

  SnappedMesh::RasterXY low_{kAbove, kAbove};  // of the columns
  double perStepX_ = 0, perStepY_ = 0;
  int side_ = 1;  // cells along x and y
  std::vector<std::uint32_t> offsets_;
  std::vector<Entry> entries_;
};

struct Hit {
  double depth;
  std::int32_t sign;
  std::uint32_t column;
};

// The crossings for which keep(column, depth) is true, in the order of the triangles, one list for
// every kPart triangles.
template <typename Columns, typename Keep>
std::vector<std::vector<Hit>> hitsOf(const SnappedMesh& mesh, const Columns& columns,
                                     const Keep& keep) {
  RawArray<Cell> cells(mesh.xy.size());
  parallelFor(cells.size(), 1 << 14, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) cells[i] = columns.cell(mesh.xy[i]);
  });
  std::vector<std::vector<Hit>> parts((mesh.triangles.size() + kPart - 1) / kPart);
  parallelFor(mesh.triangles.size(), kPart, [&](std::size_t begin, std::size_t end) {
    std::vector<Hit> hits;
    for (std::size_t t = begin; t < end; ++t) {
      const auto& [ia, ib, ic] = mesh.triangles[t];
      const Cell &a = cells[std::size_t(ia)], &b = cells[std::size_t(ib)],
                 &c = cells[std::size_t(ic)];
      const Reach reach =
          columns.between({std::min(a.x, std::min(b.x, c.x)), std::min(a.y, std::min(b.y, c.y))},
                          {std::max(a.x, std::max(b.x, c.x)), std::max(a.y, std::max(b.y, c.y))});
      if (reach.empty()) continue;
      const Footprint footprint(mesh.point(ia), mesh.point(ib), mesh.point(ic));
      if (footprint.empty()) continue;
      columns.visit(reach, [&](std::uint32_t column, std::int32_t x, std::int32_t y) {
        footprint.test(x, y, [&](double depth) {
          if (keep(column, depth)) hits.push_back({depth, footprint.sign(), column});
        });
      });
    }
    parts[begin / kPart] = std::move(hits);
  });
  return parts;
}

bool before(const Crossing& a, const Crossing& b) {
  return a.depth < b.depth || (a.depth == b.depth && a.sign > b.sign);
}

template <typename Columns>
Crossings cast(const SnappedMesh& mesh, std::size_t count, const Columns& columns) {
  constexpr std::size_t kMost = std::numeric_limits<std::uint32_t>::max();
  require(count <= kMost, "{} columns were asked for, more than {}; use fewer", count, kMost);
  const auto parts = hitsOf(mesh, columns, [](std::uint32_t, double) { return true; });
  Crossings result;
  result.offsets.assign(count + 1, 0);
  std::size_t all = 0;
  for (const std::vector<Hit>& hits : parts) {
    all += hits.size();
    for (const Hit& hit : hits) ++result.offsets[hit.column + 1];
  }
  require(all <= kMost, "the columns cross the mesh {} times, more than {}; use fewer columns", all,
          kMost);
  for (std::size_t c = 1; c < result.offsets.size(); ++c)
    result.offsets[c] += result.offsets[c - 1];
  result.all.resize(all);
  std::vector<std::uint32_t> cursor(result.offsets.begin(), result.offsets.end() - 1);
  for (const std::vector<Hit>& hits : parts)
    for (const Hit& hit : hits) result.all[cursor[hit.column]++] = {hit.depth, hit.sign};
  parallelFor(count, 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c)
      std::sort(result.all.begin() + result.offsets[c], result.all.begin() + result.offsets[c + 1],
                before);
  });
  return result;
}

}  // namespace

SnappedMesh snapToRaster(const TriangleMesh& mesh) {
  SnappedMesh snapped;
  requireSound(mesh);
  snapped.triangles = mesh.triangles;
  if (mesh.points.empty()) return snapped;
  snapped.points = mesh.points;
  const Aabb box = bounds(mesh);
  snapped.origin = box.min.head<2>();
  const double extent = box.size().head<2>().maxCoeff();
  if (extent > 0) snapped.step = extent / kRaster;
  snapped.xy.resize(mesh.points.size());
  // The highest point may round to one step beyond the raster; it is clamped.
  const auto stepsTo = [&](double offset) {
    return std::int32_t(std::min(offset / snapped.step + 0.5, double(kRaster)));
  };
  parallelFor(mesh.points.size(), 1 << 14, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3& p = mesh.points[i];
      snapped.xy[i] = {stepsTo(p.x() - snapped.origin.x()), stepsTo(p.y() - snapped.origin.y())};
    }
  });
  return snapped;
}

Crossings castColumns(const SnappedMesh& mesh, const ColumnGrid& grid) {
  require(
      grid.countX >= 0 && grid.countY >= 0 && grid.origin.allFinite() && grid.pitch.allFinite() &&
          (grid.pitch.array() > 0).all(),
      "a grid of {} x {} columns, {} and {} m apart, is none; give numbers from 0 and distances "
      "above 0",
      grid.countX, grid.countY, grid.pitch.x(), grid.pitch.y());
  return cast(mesh, grid.count(), GridColumns(mesh, grid));
}

Crossings castColumns(const SnappedMesh& mesh, std::span<const Vec2> columns) {
  return cast(mesh, columns.size(),
              ListedColumns(mesh, columns.size(), [&](std::size_t i) { return columns[i]; }));
}

std::vector<std::int32_t> windingNumbers(const SnappedMesh& mesh, std::span<const Vec3> points) {
  std::vector<std::int32_t> winding(points.size(), 0);
  const ListedColumns columns(mesh, points.size(),
                              [&](std::size_t i) { return Vec2(points[i].head<2>()); });
  const auto parts = hitsOf(
      mesh, columns, [&](std::uint32_t point, double depth) { return depth < points[point].z(); });
  for (const std::vector<Hit>& hits : parts)
    for (const Hit& hit : hits) winding[hit.column] += hit.sign;
  return winding;
}

std::int32_t SampleLine::upTo(double depth) const {
  auto i = std::int32_t(std::clamp(std::floor((depth - first) / pitch) + 1, 0.0, double(count)));
  while (i > 0 && at(i - 1) > depth) --i;
  while (i < count && at(i) <= depth) ++i;
  return i;
}

}  // namespace resect
