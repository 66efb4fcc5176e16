// Prepares one triangle for the rasteriser of collision/columns.h: edge functions, fill rule and
// depth. No other code uses this file.
#pragma once

#include <cstdint>

#include "collision/columns.h"

namespace resect {

// Number of raster steps over the larger of the mesh's extents along x and y.
inline constexpr std::int32_t kRaster = 1 << 30;
// Raster coordinates for columns that lie outside the extent of the mesh: below it (kBelow), or
// above it (kAbove). No triangle covers such a column.
inline constexpr std::int32_t kBelow = -1, kAbove = kRaster + 1;

// Raster coordinate of a column. offset: from the mesh's lowest x or y to the column, m. step: one
// raster step, m.
inline std::int32_t snapColumn(double offset, double step) {
  const double steps = offset / step + 0.5;  // for steps >= 0 truncation is floor()
  return !(steps >= 0) ? kBelow : steps >= kRaster + 1.0 ? kAbove : std::int32_t(steps);
}

// One triangle on the raster. Its corners are taken in the order that makes its area positive.
class Footprint {
 public:
  Footprint(const SnappedMesh::Point& a, const SnappedMesh::Point& b, const SnappedMesh::Point& c)
      : x0_(a.x), y0_(a.y), z_(a.z), dz1_(b.z - a.z), dz2_(c.z - a.z) {
    const std::int64_t bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
    const std::int64_t area = bx * cy - by * cx;
    // If area > 0 the triangle faces upwards (+z), and a column leaves the body through it. If area
    // < 0 the triangle faces downwards; then its edges are reversed.
    const std::int64_t turn =
        2 * std::int64_t(area > 0) - 1;  // branch-free: the sign is unpredictable
    sign_ = std::int32_t(-turn);
    area_ = turn * area;
    edge_[0] = {turn * (cx - bx), turn * (cy - by), area_};
    edge_[1] = {turn * -cx, turn * -cy, 0};
    edge_[2] = {turn * bx, turn * by, 0};
    for (Edge& e : edge_) {
      // A column at (x, y) counts as shifted to (x + s, y + s^2), where s > 0 is infinitesimal.
      // This changes the edge function by -dy s + dx s^2. A column on the edge is covered if the
      // change is positive.
      e.notOwned = !((e.dy < 0) | ((e.dy == 0) & (e.dx > 0)));
      e.start -= e.notOwned;
    }
  }

  bool empty() const { return area_ == 0; }    // seen edge-on: covers no column
  std::int32_t sign() const { return sign_; }  // Crossing::sign of the triangle's crossings

  // Calls hit(depth) if the triangle covers the column at (x, y), in raster steps.
  template <typename Hit>
  void test(std::int32_t x, std::int32_t y, Hit&& hit) const {
    const std::int64_t v0 = at(edge_[0], x, y), v1 = at(edge_[1], x, y), v2 = at(edge_[2], x, y);
    if ((v0 | v1 | v2) < 0) return;
    hit(z_ + (double(v1 + edge_[1].notOwned) * dz1_ + double(v2 + edge_[2].notOwned) * dz2_) /
                 double(area_));
  }

 private:
  // The edge function of edge i, which is opposite to corner i. dx, dy: the edge as a vector.
  // start: the value at corner 0, minus `notOwned`. The function is not negative if the column lies
  // to the left of the edge, or if it lies on the edge and notOwned is 0. Its absolute value is
  // below 2^62.
  struct Edge {
    std::int64_t dx, dy, start;
    std::int64_t notOwned = 0;  // 1: columns on the edge belong to the triangle beyond it
  };
  std::int64_t at(const Edge& e, std::int64_t x, std::int64_t y) const {
    return e.start + e.dx * (y - y0_) - e.dy * (x - x0_);
  }

  Edge edge_[3];
  std::int64_t x0_, y0_;  // corner 0, raster steps
  // z_: depth of corner 0, m. dz1_, dz2_: depths of corners 1 and 2 minus the depth of corner 0, m.
  double z_, dz1_, dz2_;
  std::int64_t area_ = 0;  // twice the area, raster steps squared
  std::int32_t sign_ = 0;
};

}  // namespace resect
