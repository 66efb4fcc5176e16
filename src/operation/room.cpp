#include "operation/room.h"

#include <algorithm>

namespace resect {

FieldPlace fieldPlace(const Aabb& organs) {
  constexpr double kLiver = 0.234;  // m: across the built-in liver, round which the field was made
  const double across = std::max(organs.size().x(), organs.size().z());
  return {{organs.centre().x(), 0, organs.centre().z()}, std::clamp(across / kLiver, 0.6, 1.6)};
}

TriangleMesh toolBoxWalls() {
  constexpr double kHalfWidth = 0.15, kHalfDepth = 0.11, kHeight = 0.025, kThickness = 0.012;  // m
  TriangleMesh walls;
  // Corners anticlockwise from above, of the outer border and then the inner; below, then above.
  for (const double y : {0.0, kHeight})
    for (const double inset : {0.0, kThickness})
      for (const auto& [x, z] :
           {std::pair(1, 1), std::pair(1, -1), std::pair(-1, -1), std::pair(-1, 1)})
        walls.points.emplace_back(x * (kHalfWidth - inset), y, z * (kHalfDepth - inset));
  const auto quad = [&](int a, int b, int c, int d) {
    walls.triangles.push_back({a, b, c});
    walls.triangles.push_back({a, c, d});
  };
  for (int i = 0; i < 4; ++i) {
    const int next = (i + 1) % 4;
    quad(i, next, 8 + next, 8 + i);            // outside
    quad(4 + next, 4 + i, 12 + i, 12 + next);  // inside
    quad(8 + i, 8 + next, 12 + next, 12 + i);  // top
    quad(next, i, 4 + i, 4 + next);            // bottom
  }
  return walls;
}

}  // namespace resect
