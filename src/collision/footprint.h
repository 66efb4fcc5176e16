// Does a triangle cover a column of the raster, and at which depth? The exact test under all of
// collision/columns.h; not for use elsewhere.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "collision/columns.h"

namespace resect {

inline constexpr double kRaster = 1 << 30;
// Where columns beside the mesh are put: no triangle reaches them.
inline constexpr std::int32_t kBelow = -1, kAbove = (1 << 30) + 1;

inline std::int32_t snapColumn(double offset, double step) {
  const double steps = std::floor(offset / step + 0.5);
  return !(steps >= 0) ? kBelow : steps > kRaster ? kAbove : std::int32_t(steps);
}

// One triangle over the raster, turned so that its area is positive.
struct Footprint {
  struct Edge {
    std::int64_t x, y, dx, dy, owned;  // start, direction; owned: the value from which it covers
    // > 0 left of the edge, 0 on it. |value| < 2^62.
    std::int64_t at(std::int64_t px, std::int64_t py) const {
      return dx * (py - y) - dy * (px - x);
    }
  };
  Edge edge[3];        // edge i lies opposite of corner i
  double z, dz1, dz2;  // depth of corner 0, rise to corners 1 and 2
  double area;         // twice the area, raster steps squared; <= 0: covers nothing
  std::int32_t sign;

  Footprint(const SnappedMesh::Point& a, const SnappedMesh::Point& b0,
            const SnappedMesh::Point& c0) {
    std::int64_t twice =
        std::int64_t(b0.x - a.x) * (c0.y - a.y) - std::int64_t(b0.y - a.y) * (c0.x - a.x);
    // A face that looks up is where the column leaves.
    sign = twice > 0 ? -1 : 1;
    const SnappedMesh::Point& b = twice > 0 ? b0 : c0;
    const SnappedMesh::Point& c = twice > 0 ? c0 : b0;
    edge[0] = makeEdge(b, c);
    edge[1] = makeEdge(c, a);
    edge[2] = makeEdge(a, b);
    z = a.z;
    dz1 = b.z - a.z;
    dz2 = c.z - a.z;
    area = double(std::abs(twice));
  }

  static Edge makeEdge(const SnappedMesh::Point& from, const SnappedMesh::Point& to) {
    const std::int64_t dx = to.x - from.x, dy = to.y - from.y;
    // At (x + e, y + e^2) the value grows by -dy e + dx e^2: a column on the edge is covered if
    // that is positive.
    const bool owns = dy < 0 || (dy == 0 && dx > 0);
    return {from.x, from.y, dx, dy, owns ? 0 : 1};
  }

  // Calls hit(depth) if the triangle covers the column.
  template <typename Hit>
  void test(std::int64_t x, std::int64_t y, Hit&& hit) const {
    if (edge[0].at(x, y) < edge[0].owned) return;
    const std::int64_t w1 = edge[1].at(x, y);
    if (w1 < edge[1].owned) return;
    const std::int64_t w2 = edge[2].at(x, y);
    if (w2 < edge[2].owned) return;
    hit(z + (double(w1) * dz1 + double(w2) * dz2) / area);
  }
};

}  // namespace resect
