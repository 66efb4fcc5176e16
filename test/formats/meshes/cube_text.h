// A cube of side 1 as the pieces of text that mesh files consist of.
#pragma once

#include <fmt/format.h>

#include <array>
#include <string>

#include "geometry/triangle_mesh.h"

namespace resect::test {

inline constexpr std::array<Triangle, 12> kCubeTriangles{{{0, 2, 3},
                                                          {0, 3, 1},
                                                          {4, 5, 7},
                                                          {4, 7, 6},
                                                          {0, 1, 5},
                                                          {0, 5, 4},
                                                          {2, 6, 7},
                                                          {2, 7, 3},
                                                          {0, 4, 6},
                                                          {0, 6, 2},
                                                          {1, 3, 7},
                                                          {1, 7, 5}}};

inline TriangleMesh cube() {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) mesh.points.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
  mesh.triangles.assign(kCubeTriangles.begin(), kCubeTriangles.end());
  return mesh;
}

// Lines "{before}x y z\n" of its 8 points, where 1 is printed as `one`.
inline std::string cubePoints(const std::string& before = "", const std::string& one = "1") {
  std::string text;
  for (const Vec3& p : cube().points) {
    text += before;
    for (int k = 0; k < 3; ++k) text += (p[k] == 1 ? one : "0") + (k < 2 ? " " : "\n");
  }
  return text;
}

// Lines "{before}a b c\n" of its 12 triangles, whose points are counted from `first`.
inline std::string cubeFaces(const std::string& before, int first) {
  std::string text;
  for (const Triangle& t : kCubeTriangles)
    text += fmt::format("{}{} {} {}\n", before, t[0] + first, t[1] + first, t[2] + first);
  return text;
}

}  // namespace resect::test
