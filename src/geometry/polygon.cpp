#include "geometry/polygon.h"

#include <Eigen/Geometry>

namespace resect {
namespace {

// Twice the signed area of the triangle, seen from the tip of the unit normal.
double turn(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal) {
  return (b - a).cross(c - a).dot(normal);
}

}  // namespace

void triangulatePolygon(std::span<const Vec3> points, std::span<const std::int32_t> loop,
                        std::vector<Triangle>& triangles) {
  const std::size_t n = loop.size();
  if (n < 3) return;
  const auto fan = [&](std::span<const std::int32_t> rest) {
    for (std::size_t i = 1; i + 1 < rest.size(); ++i)
      triangles.push_back({rest[0], rest[i], rest[i + 1]});
  };
  if (n == 3) return fan(loop);

  // Newell's area vector, from the first corner for precision.
  Vec3 normal = Vec3::Zero();
  const Vec3& origin = points[loop[0]];
  for (std::size_t i = 1; i + 1 < n; ++i)
    normal += (points[loop[i]] - origin).cross(points[loop[i + 1]] - origin);
  if (!(normal.norm() > 0)) return fan(loop);
  normal.normalize();

  std::vector<std::int32_t> rest(loop.begin(), loop.end());
  const auto corner = [&](std::size_t i) -> const Vec3& { return points[rest[i % rest.size()]]; };
  bool convex = true;
  for (std::size_t i = 0; i < n && convex; ++i)
    convex = turn(corner(i), corner(i + 1), corner(i + 2), normal) >= 0;
  // Left turns at all corners do not exclude a star polygon; the fan's triangles must not turn back
  // either.
  for (std::size_t i = 1; i + 1 < n && convex; ++i)
    convex = turn(corner(0), corner(i), corner(i + 1), normal) >= 0;
  if (convex) return fan(rest);

  while (rest.size() > 3) {
    const std::size_t m = rest.size();
    std::size_t ear = m;
    for (std::size_t i = 0; i < m && ear == m; ++i) {
      const Vec3 &a = corner(i + m - 1), &b = corner(i), &c = corner(i + 1);
      if (!(turn(a, b, c, normal) > 0)) continue;
      bool empty = true;
      for (std::size_t j = 2; j < m - 1 && empty; ++j) {
        const Vec3& p = corner(i + j);
        // A corner repeated by a bridge to a hole lies on the ear's own corners, not inside it.
        if (p == a || p == b || p == c) continue;
        empty = !(turn(a, b, p, normal) >= 0 && turn(b, c, p, normal) >= 0 &&
                  turn(c, a, p, normal) >= 0);
      }
      if (empty) ear = i;
    }
    if (ear == m) {
      // No ear: flat corners or a crossing. Cut the corner of least area, which changes least.
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < m; ++i) {
        const double size = std::abs(turn(corner(i + m - 1), corner(i), corner(i + 1), normal));
        if (size < least) least = size, ear = i;
      }
      if (ear == m) ear = 0;
    }
    triangles.push_back({rest[(ear + m - 1) % m], rest[ear], rest[(ear + 1) % m]});
    rest.erase(rest.begin() + std::ptrdiff_t(ear));
  }
  fan(rest);
}

}  // namespace resect
