// Does a triangle cover a column of the raster, and at which depth? The exact test under all of
// collision/columns.h; not for use elsewhere.
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>

#include "collision/columns.h"

namespace resect {

inline constexpr double kRaster = 1 << 30;
// Where columns beside the mesh are put: no triangle reaches them.
inline constexpr std::int32_t kBelow = -1, kAbove = (1 << 30) + 1;

inline std::int32_t snapColumn(double offset, double step) {
  const double steps = offset / step + 0.5;  // whole steps are counted from 0 on: no floor() needed
  return !(steps >= 0) ? kBelow : steps >= kRaster + 1 ? kAbove : std::int32_t(steps);
}

// One triangle over the raster, turned so that its area is positive.
struct Footprint {
  // start + dx * y - dy * x >= 0 if the column lies left of the edge, or on it and the edge owns
  // it; its size is below 2^62.
  struct Edge {
    std::int64_t dx, dy, start;
    std::int64_t notOwned;  // 1 if columns on the edge belong to the triangle beyond it
  };
  Edge edge[3];         // edge i lies opposite of corner i
  double z, dz1, dz2;   // depth of corner 0, rise to corners 1 and 2
  std::int64_t x0, y0;  // corner 0: columns are taken from here, so that nothing overflows
  double area;          // twice the area, raster steps squared; 0: covers nothing
  std::int32_t sign;    // of its crossings

  Footprint(const SnappedMesh::Point& a, const SnappedMesh::Point& b, const SnappedMesh::Point& c) {
    x0 = a.x;
    y0 = a.y;
    const std::int64_t bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
    z = a.z;
    dz1 = b.z - a.z;
    dz2 = c.z - a.z;
    const std::int64_t twice = bx * cy - by * cx;
    // A face that looks up is where the column leaves. One that looks down has its edges turned
    // round: without a branch, for no processor guesses which way a face looks.
    const std::int64_t down = -std::int64_t(twice <= 0);  // all bits if it looks down
    const auto turned = [down](std::int64_t v) { return (v ^ down) - down; };
    sign = std::int32_t(-1 - 2 * down);
    edge[0] = makeEdge(turned(cx - bx), turned(cy - by), turned(twice));
    edge[1] = makeEdge(turned(-cx), turned(-cy), 0);
    edge[2] = makeEdge(turned(bx), turned(by), 0);
    area = double(turned(twice));
  }

  // `start` is the value at corner 0.
  static Edge makeEdge(std::int64_t dx, std::int64_t dy, std::int64_t start) {
    // At (x + e, y + e^2) the value grows by -dy e + dx e^2: a column on the edge is covered if
    // that is positive.
    const bool owns = (dy < 0) | ((dy == 0) & (dx > 0));
    return {dx, dy, start - !owns, !owns};
  }

  // A column over the triangle: covered if no value is negative, and its depth where it is.
  struct Place {
    std::int64_t v0, v1, v2;
    bool covered() const { return (v0 | v1 | v2) >= 0; }
  };
  // A line along x.
  struct Row {
    std::int64_t x0, start[3], dy[3];
    Place place(std::int64_t x) const {
      x -= x0;
      return {start[0] - dy[0] * x, start[1] - dy[1] * x, start[2] - dy[2] * x};
    }
  };
  Row row(std::int64_t y) const {
    y -= y0;
    return {x0,
            {edge[0].start + edge[0].dx * y, edge[1].start + edge[1].dx * y,
             edge[2].start + edge[2].dx * y},
            {edge[0].dy, edge[1].dy, edge[2].dy}};
  }
  double depth(const Place& p) const {
    return z +
           (double(p.v1 + edge[1].notOwned) * dz1 + double(p.v2 + edge[2].notOwned) * dz2) / area;
  }

  // Calls hit(depth) if the triangle covers the column.
  template <typename Hit>
  void test(std::int64_t x, std::int64_t y, Hit&& hit) const {
    const Place p = row(y).place(x);
    if (p.covered()) hit(depth(p));
  }
};

inline Footprint footprintOf(const SnappedMesh& mesh, std::size_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return Footprint(mesh.point(a), mesh.point(b), mesh.point(c));
}

}  // namespace resect
