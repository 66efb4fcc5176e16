// Comparison of two surfaces regardless of the order and numbering of their triangles.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace resect::test {

// Triangles with their corners, without holes, in the order given.
inline std::vector<std::array<float, 9>> corners(std::span<const Vec3f> points,
                                                 std::span<const Triangle> triangles) {
  std::vector<std::array<float, 9>> result;
  for (const Triangle& t : triangles)
    if (t[0] != t[1]) {
      auto& triangle = result.emplace_back();
      for (int c = 0; c < 3; ++c)
        std::copy_n(points[std::size_t(t[c])].data(), 3, triangle.begin() + 3 * c);
    }
  return result;
}

inline std::vector<std::array<float, 9>> sortedCorners(std::span<const Vec3f> points,
                                                       std::span<const Triangle> triangles) {
  auto result = corners(points, triangles);
  std::ranges::sort(result);
  return result;
}

inline std::vector<std::array<float, 9>> sortedCorners(const TriangleMesh& mesh) {
  std::vector<Vec3f> points;
  for (const Vec3& p : mesh.points) points.push_back(p.cast<float>());
  return sortedCorners(points, mesh.triangles);
}

}  // namespace resect::test
