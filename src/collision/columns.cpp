#include "collision/columns.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "collision/column_order.h"
#include "collision/footprint.h"

namespace resect {
namespace {

// Half-open ranges of columns or cells that a triangle may cover.
struct Range {
  std::int32_t first, last;
  bool empty() const { return first >= last; }
};
Range rangeOf(std::int32_t a, std::int32_t b, std::int32_t c) {
  return {std::min({a, b, c}), std::max({a, b, c})};
}

// A triangle and the rows and columns it may cover.
struct Reach {
  std::uint32_t triangle;
  Range rows, columns;
};

// Triangles by the band of rows they reach; a band's triangles keep their order.
struct Bands {
  int rowsPerBand = 1;
  std::vector<std::uint32_t> offsets;
  std::vector<Reach> reaches;
  std::size_t count() const { return offsets.size() - 1; }
  std::span<const Reach> operator[](std::size_t band) const {
    return {reaches.data() + offsets[band], reaches.data() + offsets[band + 1]};
  }

  // reachOf(t): the rows and columns of triangle t; either empty if it covers no column.
  template <typename ReachOf>
  Bands(int rows, int wantedBands, std::size_t triangleCount, ReachOf&& reachOf) {
    rowsPerBand = std::max(1, (rows + wantedBands - 1) / wantedBands);
    offsets.assign((rows + rowsPerBand - 1) / rowsPerBand + 1, 0);
    std::vector<Reach> kept;
    kept.reserve(triangleCount);
    for (std::size_t t = 0; t < triangleCount; ++t) {
      const Reach reach = reachOf(std::uint32_t(t));
      if (reach.rows.empty() || reach.columns.empty()) continue;
      kept.push_back(reach);
      forEachBand(reach, [&](int band) { ++offsets[band + 1]; });
    }
    for (std::size_t b = 1; b < offsets.size(); ++b) offsets[b] += offsets[b - 1];
    reaches.resize(offsets.back());
    std::vector<std::uint32_t> cursor(offsets.begin(), offsets.end() - 1);
    for (const Reach& reach : kept)
      forEachBand(reach, [&](int band) { reaches[cursor[band]++] = reach; });
  }

  template <typename Visit>
  void forEachBand(const Reach& reach, Visit&& visit) const {
    const int last = (reach.rows.last - 1) / rowsPerBand;
    for (int band = reach.rows.first / rowsPerBand; band <= last; ++band) visit(band);
  }
};

// Columns at any places, in the cells of a coarse grid over them.
struct Buckets {
  struct Entry {
    std::int32_t x, y;
    std::uint32_t column;
  };
  std::int32_t lowX = kAbove, lowY = kAbove, highX = kBelow, highY = kBelow;  // of the columns
  double cellsPerStepX = 0, cellsPerStepY = 0;
  int countX = 0, countY = 0;
  std::vector<std::uint32_t> offsets;
  std::vector<Entry> entries;

  // By a product: for every corner of every triangle a quotient takes longer than all the rest. Any
  // rounding will do that never lets a greater place have a lesser cell.
  int cellX(std::int32_t x) const { return cell(double(x) - lowX, cellsPerStepX, countX); }
  int cellY(std::int32_t y) const { return cell(double(y) - lowY, cellsPerStepY, countY); }
  static int cell(double steps, double cellsPerStep, int count) {
    return int(std::clamp(steps * cellsPerStep, 0.0, count - 1.0));
  }
};

// place(i): x, y of column i, m. Columns beside the mesh are left out.
template <typename Place>
Buckets bucketColumns(const SnappedMesh& mesh, std::size_t count, Place&& place) {
  Buckets buckets;
  std::vector<Buckets::Entry> entries;
  entries.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 p = place(i);
    const std::int32_t x = snapColumn(p.x() - mesh.origin.x(), mesh.step);
    const std::int32_t y = snapColumn(p.y() - mesh.origin.y(), mesh.step);
    if (x == kBelow || x == kAbove || y == kBelow || y == kAbove) continue;
    entries.push_back({x, y, std::uint32_t(i)});
    buckets.lowX = std::min(buckets.lowX, x), buckets.highX = std::max(buckets.highX, x);
    buckets.lowY = std::min(buckets.lowY, y), buckets.highY = std::max(buckets.highY, y);
  }
  if (entries.empty()) return buckets;
  const int side = int(std::clamp(std::sqrt(double(entries.size()) / 2), 1.0, 1024.0));
  buckets.countX = buckets.countY = side;
  buckets.cellsPerStepX = side / (double(buckets.highX) - buckets.lowX + 1);
  buckets.cellsPerStepY = side / (double(buckets.highY) - buckets.lowY + 1);
  buckets.offsets.assign(std::size_t(side) * side + 1, 0);
  const auto bucketOf = [&](const Buckets::Entry& e) {
    return std::size_t(buckets.cellY(e.y)) * side + buckets.cellX(e.x);
  };
  for (const auto& e : entries) ++buckets.offsets[bucketOf(e) + 1];
  for (std::size_t b = 1; b < buckets.offsets.size(); ++b)
    buckets.offsets[b] += buckets.offsets[b - 1];
  buckets.entries.resize(entries.size());
  std::vector<std::uint32_t> cursor(buckets.offsets.begin(), buckets.offsets.end() - 1);
  for (const auto& e : entries) buckets.entries[cursor[bucketOf(e)]++] = e;
  return buckets;
}

// Calls visit(column, depth, sign) for every crossing; all calls of one column come from one
// thread, in the order of the triangles.
template <typename Visit>
void visitCrossings(const SnappedMesh& mesh, const Buckets& buckets, Visit&& visit) {
  if (buckets.entries.empty()) return;
  const int wanted =
      int(std::clamp<std::size_t>((mesh.triangles.size() + buckets.entries.size()) / 4096, 1, 32));
  const Bands bands(buckets.countY, wanted, mesh.triangles.size(), [&](std::uint32_t t) {
    const auto& [ia, ib, ic] = mesh.triangles[t];
    const SnappedMesh::Place &a = mesh.places[std::size_t(ia)], &b = mesh.places[std::size_t(ib)],
                             &c = mesh.places[std::size_t(ic)];
    const Range x = rangeOf(a.x, b.x, c.x), y = rangeOf(a.y, b.y, c.y);
    if (x.empty() || y.empty() || x.first > buckets.highX || y.first > buckets.highY ||
        x.last < buckets.lowX || y.last < buckets.lowY)
      return Reach{t, {0, 0}, {0, 0}};
    return Reach{t,
                 {buckets.cellY(y.first), buckets.cellY(y.last) + 1},
                 {buckets.cellX(x.first), buckets.cellX(x.last) + 1}};
  });
  parallelFor(bands.count(), 1, [&](std::size_t firstBand, std::size_t lastBand) {
    for (std::size_t band = firstBand; band < lastBand; ++band) {
      const int bandFirst = int(band) * bands.rowsPerBand;
      const int bandLast = std::min(buckets.countY, bandFirst + bands.rowsPerBand);
      for (const Reach& reach : bands[band]) {
        const Footprint footprint = footprintOf(mesh, reach.triangle);
        if (footprint.area == 0) continue;
        const int rowLast = std::min(bandLast, reach.rows.last);
        for (int row = std::max(bandFirst, reach.rows.first); row < rowLast; ++row) {
          const std::size_t base = std::size_t(row) * buckets.countX;
          const std::uint32_t last = buckets.offsets[base + reach.columns.last];
          for (std::uint32_t e = buckets.offsets[base + reach.columns.first]; e < last; ++e) {
            const Buckets::Entry& entry = buckets.entries[e];
            footprint.test(entry.x, entry.y,
                           [&](double depth) { visit(entry.column, depth, footprint.sign); });
          }
        }
      }
    }
  });
}

}  // namespace

Crossings castColumns(const SnappedMesh& mesh, std::span<const Vec2> columns) {
  Crossings result;
  result.offsets.assign(columns.size() + 1, 0);
  if (mesh.places.empty()) return result;
  const Buckets buckets =
      bucketColumns(mesh, columns.size(), [&](std::size_t i) { return columns[i]; });
  visitCrossings(mesh, buckets,
                 [&](std::uint32_t column, double, std::int32_t) { ++result.offsets[column + 1]; });
  for (std::size_t c = 1; c < result.offsets.size(); ++c)
    result.offsets[c] += result.offsets[c - 1];
  result.all.resize(result.offsets.back());
  std::vector<std::uint32_t> cursor(result.offsets.begin(), result.offsets.end() - 1);
  visitCrossings(mesh, buckets, [&](std::uint32_t column, double depth, std::int32_t sign) {
    result.all[cursor[column]++] = {depth, sign};
  });
  for (std::size_t c = 0; c < columns.size(); ++c)
    sortColumn(result.all.data() + result.offsets[c], result.all.data() + result.offsets[c + 1]);
  return result;
}

std::vector<std::int32_t> windingNumbers(const SnappedMesh& mesh, std::span<const Vec3> points) {
  std::vector<std::int32_t> winding(points.size(), 0);
  if (mesh.places.empty()) return winding;
  const Buckets buckets =
      bucketColumns(mesh, points.size(), [&](std::size_t i) { return Vec2(points[i].head<2>()); });
  visitCrossings(mesh, buckets, [&](std::uint32_t point, double depth, std::int32_t sign) {
    if (depth < points[point].z()) winding[point] += sign;
  });
  return winding;
}

}  // namespace resect
