// By estimate, two points at a time: only near a line the lines are asked.
#include "collision/grid_lines.h"

#include <cmath>

#include "base/assert.h"
#include "base/instruction_set.h"
#include "base/parallel.h"

// Every function that gives such vectors is inlined: how they would be passed does not matter.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace resect {

GridLines::GridLines(double origin, double pitch, int lines, double meshOrigin, double step)
    : count(lines),
      at(std::size_t(lines + kLinesBeyond)),
      linesPerStep(step / pitch),
      first((meshOrigin - origin) / pitch),
      slack(1e-6 + 2 * linesPerStep +
            0x1p-50 * (lines + (std::abs(origin) + std::abs(meshOrigin)) / pitch)) {
  for (int i = 0; i < count + kLinesBeyond; ++i)
    at[std::size_t(i)] = snapColumn(origin + i * pitch - meshOrigin, step);
}

std::int32_t GridLines::lowerBound(std::int32_t place) const {
  const double about = estimate(place);
  int i = !(about > 0) ? 0 : about < count ? int(about) + 1 : count;
  while (i > 0 && at[std::size_t(i - 1)] >= place) --i;
  while (i < count && at[std::size_t(i)] < place) ++i;
  return i;
}

LineRange narrowed(const GridLines& columns, const Footprint& footprint, std::int32_t y,
                   const LineRange& all) {
  const Footprint::Row row = footprint.row(y);
  double low = all.first, high = all.last;
  for (int e = 0; e < 3; ++e) {
    const double dy = double(footprint.edge[e].dy);
    if (dy == 0) continue;
    const double at = columns.estimate(double(footprint.x0) + double(row.start[e]) / dy);
    if (dy < 0) low = std::max(low, at - columns.slack);
    if (dy > 0) high = std::min(high, at + columns.slack);
  }
  LineRange range = all;
  range.first = int(std::min(low, double(all.last)));
  range.last = int(std::max(high, double(all.first))) + 1;
  range.last = std::min(range.last, all.last);
  return range;
}

std::pair<LineRange, LineRange> MeshOnGrid::reach(std::size_t triangle) const {
  const auto& [ia, ib, ic] = mesh.triangles[triangle];
  const GridCell &a = cells[std::size_t(ia)], &b = cells[std::size_t(ib)],
                 &c = cells[std::size_t(ic)];
  return {LineRange::round(a.column, b.column, c.column), LineRange::round(a.row, b.row, c.row)};
}

namespace {

typedef double Four __attribute__((vector_size(32)));
typedef std::int32_t FourInts __attribute__((vector_size(16)));

RESECT_WIDEST void findCells(const SnappedMesh::Place* places, std::size_t count,
                             const GridLines& x, const GridLines& y, GridCell* to) {
  const Four first{x.first, y.first, x.first, y.first};
  const Four perStep{x.linesPerStep, y.linesPerStep, x.linesPerStep, y.linesPerStep};
  const Four most{x.count + 0.5, y.count + 0.5, x.count + 0.5, y.count + 0.5};
  const double slack = std::max(x.slack, y.slack);
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

}  // namespace

GridOnMesh::GridOnMesh(const SnappedMesh& snapped, const ColumnGrid& grid)
    : mesh(snapped),
      columns(grid.origin.x(), grid.pitch.x(), grid.countX, mesh.origin.x(), mesh.step),
      rows(grid.origin.y(), grid.pitch.y(), grid.countY, mesh.origin.y(), mesh.step) {
  RESECT_ASSERT(grid.pitch.x() > 0 && grid.pitch.y() > 0);
}

MeshOnGrid::MeshOnGrid(const SnappedMesh& snapped, const ColumnGrid& grid)
    : GridOnMesh(snapped, grid),
      cells(std::make_unique_for_overwrite<GridCell[]>(mesh.places.size())) {
  parallelFor(mesh.places.size(), 1 << 14, [&](std::size_t begin, std::size_t end) {
    findCells(mesh.places.data() + begin, end - begin, columns, rows, cells.get() + begin);
  });
}

}  // namespace resect
