// Scanline rasteriser: finds all crossings of lines along +z (columns) with a closed mesh, exactly.
//
// x and y of the mesh's points and of the columns are snapped to one integer raster (2^30 steps
// over the larger of the mesh's extents in x and y; a step is 0.2 nm on a liver), so that every
// edge function is an exact 64-bit integer. A column through an edge or a vertex is treated as if
// shifted by (s, s^2), where s > 0 is infinitesimal, so exactly one of the neighbouring triangles
// covers it. So for a closed, oriented mesh the signs of every column's crossings sum to zero,
// whatever the shapes of the triangles. The raster depends on the mesh alone. So a column has the
// same crossings whether it is cast alone or with others, in a grid or in a list, at any number of
// threads.
//
// Cost: a pass over the mesh's points and triangles, then work in proportion to the crossings.
// Sources: layered depth images for collisions (Heidelberger, Teschner, Gross 2003); fill rule as
// symbolic perturbation (Edelsbrunner, Muecke 1990).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "base/raw_array.h"
#include "geometry/triangle_mesh.h"

namespace resect {

using Vec2 = Eigen::Vector2d;

struct Crossing {
  double depth;       // z, m
  std::int32_t sign;  // +1 entering, -1 leaving the body as z grows
};

// The crossings of many columns. Those of one column are sorted by depth; at equal depths entries
// come first.
struct Crossings {
  std::vector<std::uint32_t> offsets;  // first crossing of each column; then the end, below 2^32
  RawArray<Crossing> all;

  std::size_t columnCount() const { return offsets.empty() ? 0 : offsets.size() - 1; }
  std::span<const Crossing> operator[](std::size_t column) const {
    return {all.data() + offsets[column], all.data() + offsets[column + 1]};
  }
};

// Column (i, j) stands at origin + (i * pitch.x, j * pitch.y) and has number j * countX + i.
struct ColumnGrid {
  Vec2 origin = Vec2::Zero();  // m
  Vec2 pitch = Vec2::Ones();   // > 0, m
  int countX = 0, countY = 0;  // >= 0

  std::size_t count() const { return std::size_t(countX) * std::size_t(countY); }
};

// A mesh snapped to its raster. It refers to the points and triangles of the mesh, so the mesh must
// outlive it.
struct SnappedMesh {
  struct RasterXY {
    std::int32_t x, y;  // raster steps from `origin`, in [0, 2^30]
  };
  struct Point {
    std::int32_t x, y;
    double z;  // m
  };
  Vec2 origin = Vec2::Zero();  // lowest x, y of the mesh, m
  double step = 1;             // one raster step, m
  RawArray<RasterXY> xy;       // without z, since most triangles are rejected by x and y alone
  std::span<const Vec3> points;
  std::span<const Triangle> triangles;

  Point point(std::int32_t i) const {
    const auto at = std::size_t(i);
    return {xy[at].x, xy[at].y, points[at].z()};
  }
};

// The mesh must be closed, oriented outwards, and finite. An empty mesh is allowed.
SnappedMesh snapToRaster(const TriangleMesh& mesh);
SnappedMesh snapToRaster(const TriangleMesh&& mesh) = delete;  // the result would outlive the mesh

// All crossings of a regular grid of columns.
Crossings castColumns(const SnappedMesh& mesh, const ColumnGrid& grid);

// All crossings of columns at given positions (x, y), m.
Crossings castColumns(const SnappedMesh& mesh, std::span<const Vec2> columns);

// For each point, the sum of the signs of the crossings below it (depth < z): the number of closed
// shells that surround the point. 0 outside; > 0 inside.
std::vector<std::int32_t> windingNumbers(const SnappedMesh& mesh, std::span<const Vec3> points);

// Calls visit(z0, z1) for every interval of a column inside the body (winding number > 0), z0 <=
// z1, in ascending order. A z with z0 < z <= z1 is inside. Shells that overlap or touch give one
// interval.
template <typename Visit>
void forEachInside(std::span<const Crossing> column, Visit&& visit) {
  int winding = 0;
  double entered = 0;
  for (const Crossing& crossing : column) {
    const int before = winding;
    winding += crossing.sign;
    if (before <= 0 && winding > 0) entered = crossing.depth;
    if (before > 0 && winding <= 0) visit(entered, crossing.depth);
  }
}

// Points along a column, in ascending order: point i stands at first + i * pitch.
struct SampleLine {
  double first, pitch;  // m; pitch > 0
  std::int32_t count;   // >= 0

  double at(std::int32_t i) const { return first + i * pitch; }
  // How many of the points lie at `depth` (finite) or below.
  std::int32_t upTo(double depth) const;
};

// Calls visit(i0, i1) for every range of points [i0, i1) of the line inside the body, i0 < i1, in
// ascending order. If no point lies between two ranges, the second begins where the first ends.
template <typename Visit>
void forEachInside(std::span<const Crossing> column, const SampleLine& line, Visit&& visit) {
  forEachInside(column, [&](double entered, double left) {
    const std::int32_t first = line.upTo(entered), end = line.upTo(left);
    if (first < end) visit(first, end);
  });
}

}  // namespace resect
