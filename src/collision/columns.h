// Scanline rasteriser: finds all crossings of columns (lines along +z) with a closed mesh. First
// the x and y of the mesh's points and of the columns are snapped to an integer raster. Then the
// rasteriser decides exactly which triangles of the snapped mesh a column crosses. Only the depth
// of a crossing is inexact, since it is computed in floating point.
//
// The raster has 2^30 steps over the mesh's extent along x or along y, whichever is larger. For a
// liver, a step is 0.2 nm. With these integers every edge function is an exact 64-bit integer. A
// column through an edge or a vertex is treated as if it were shifted by (s, s^2), where s > 0 is
// infinitesimal. The shifted column meets neither edges nor vertices. So for a closed, oriented
// mesh the signs of every column's crossings sum to zero, whatever the shapes of the triangles. The
// raster depends on the mesh alone. So a column has the same crossings whether it is cast alone or
// with others, in a grid or in a list, at any number of threads.
//
// Cost: a pass over the mesh's points and triangles; then, for each triangle, a constant time for
// each column in the triangle's bounding box; finally, sorting each column's crossings. Sources:
// Heidelberger, Teschner, Gross (2003) for layered depth images in collision detection;
// Edelsbrunner, Muecke (1990) for the symbolic perturbation of columns through edges and vertices.
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
  std::int32_t sign;  // as z grows: +1 enters the body, -1 leaves it
};

// The crossings of a number of columns. The crossings of one column are sorted by depth; at equal
// depths, crossings with sign +1 come first.
struct Crossings {
  // Per column: index in `all` of the column's first crossing. The last element is all.size().
  std::vector<std::uint32_t> offsets;
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
  int countX = 0, countY = 0;  // number of columns along x and y, >= 0

  std::size_t count() const { return std::size_t(countX) * std::size_t(countY); }
};

// A mesh snapped to its raster. A SnappedMesh refers to the points and triangles of the
// TriangleMesh that it was made from, so the TriangleMesh must outlive it.
struct SnappedMesh {
  struct RasterXY {
    std::int32_t x, y;  // raster steps from `origin`, in [0, 2^30]
  };
  struct Point {
    std::int32_t x, y;  // raster steps from `origin`
    double z;           // m
  };
  Vec2 origin = Vec2::Zero();  // lowest x, y of the mesh, m
  double step = 1;             // one raster step, m
  // Per point. z is not included, since most triangles are rejected by x and y alone.
  RawArray<RasterXY> xy;
  std::span<const Vec3> points;
  std::span<const Triangle> triangles;

  Point point(std::int32_t i) const {
    const auto at = std::size_t(i);
    return {xy[at].x, xy[at].y, points[at].z()};
  }
};

// The mesh must be closed and oriented outwards, with finite coordinates. An empty mesh is allowed.
SnappedMesh snapToRaster(const TriangleMesh& mesh);
// Deleted, since a temporary mesh would be destroyed before the result that refers to it.
SnappedMesh snapToRaster(const TriangleMesh&& mesh) = delete;

// All crossings of a regular grid of columns.
Crossings castColumns(const SnappedMesh& mesh, const ColumnGrid& grid);

// All crossings of columns at given positions (x, y), m.
Crossings castColumns(const SnappedMesh& mesh, std::span<const Vec2> columns);

// For each point, the sum of the signs of the crossings below the point (their depth is less than
// the point's z). If all shells (connected components) of the mesh face outwards, this sum is the
// number of shells that surround the point. So it is 0 outside and > 0 inside.
std::vector<std::int32_t> windingNumbers(const SnappedMesh& mesh, std::span<const Vec3> points);

// Calls visit(z0, z1) for every interval of a column that lies inside the body (winding number >
// 0), in ascending order; z0 <= z1. The interval consists of the z with z0 < z <= z1. Shells that
// overlap or touch give one interval.
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

// Points along a column, in ascending order: point i lies at z = first + i * pitch.
struct SampleLine {
  double first, pitch;  // m; pitch > 0
  std::int32_t count;   // >= 0

  double at(std::int32_t i) const { return first + i * pitch; }
  // How many points have z <= depth. `depth` must be finite.
  std::int32_t upTo(double depth) const;
};

// Does the same as forEachInside() above, but for the points of `line`. Calls visit(i0, i1) for
// every interval that contains at least one of these points, in ascending order. The interval
// contains the points i0 to i1 - 1; i0 < i1. If no point lies between two intervals, i1 of the
// first equals i0 of the second.
template <typename Visit>
void forEachInside(std::span<const Crossing> column, const SampleLine& line, Visit&& visit) {
  forEachInside(column, [&](double entered, double left) {
    const std::int32_t first = line.upTo(entered), end = line.upTo(left);
    if (first < end) visit(first, end);
  });
}

}  // namespace resect
