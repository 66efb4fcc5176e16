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
  // value(x, y) >= 0 if the column lies left of the edge, or on it and the edge owns it.
  struct Edge {
    std::int64_t dx, dy, start;
    std::int64_t notOwned;  // 1 if columns on the edge belong to the triangle beyond it
    // |value| < 2^62.
    std::int64_t value(std::int64_t x, std::int64_t y) const { return start + dx * y - dy * x; }
  };
  Edge edge[3];         // edge i lies opposite of corner i
  double z, dz1, dz2;   // depth of corner 0, rise to corners 1 and 2
  std::int64_t x0, y0;  // corner 0: columns are taken from here, so that nothing overflows
  double area;          // twice the area, raster steps squared; 0: covers nothing
  std::int32_t sign;    // of its crossings

  Footprint(const SnappedMesh::Point& a, const SnappedMesh::Point& b, const SnappedMesh::Point& c) {
    x0 = a.x;
    y0 = a.y;
    std::int64_t bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
    dz1 = b.z - a.z;
    dz2 = c.z - a.z;
    std::int64_t twice = bx * cy - by * cx;
    // A face that looks up is where the column leaves.
    sign = twice > 0 ? -1 : 1;
    if (twice < 0) {
      std::swap(bx, cx);
      std::swap(by, cy);
      std::swap(dz1, dz2);
      twice = -twice;
    }
    edge[0] = makeEdge(cx - bx, cy - by, twice);
    edge[1] = makeEdge(-cx, -cy, 0);
    edge[2] = makeEdge(bx, by, 0);
    z = a.z;
    area = double(twice);
  }

  // `value` at corner 0.
  static Edge makeEdge(std::int64_t dx, std::int64_t dy, std::int64_t value) {
    // At (x + e, y + e^2) the value grows by -dy e + dx e^2: a column on the edge is covered if
    // that is positive.
    const bool owns = dy < 0 || (dy == 0 && dx > 0);
    return {dx, dy, value - !owns, !owns};
  }

  // Calls hit(depth) if the triangle covers the column.
  template <typename Hit>
  void test(std::int64_t x, std::int64_t y, Hit&& hit) const {
    x -= x0;
    y -= y0;
    const std::int64_t v0 = edge[0].value(x, y), v1 = edge[1].value(x, y), v2 = edge[2].value(x, y);
    if ((v0 | v1 | v2) < 0) return;
    hit(z + (double(v1 + edge[1].notOwned) * dz1 + double(v2 + edge[2].notOwned) * dz2) / area);
  }
};

}  // namespace resect
