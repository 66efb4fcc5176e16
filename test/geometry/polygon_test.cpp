#include "geometry/polygon.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <numeric>

#include "geometry/measures.h"

using namespace resect;

namespace {

TriangleMesh filled(const std::vector<Vec3>& corners) {
  TriangleMesh mesh{corners, {}};
  std::vector<std::int32_t> loop(corners.size());
  std::iota(loop.begin(), loop.end(), 0);
  triangulatePolygon(mesh.points, loop, mesh.triangles);
  return mesh;
}

// In a slanted plane, so that no axis is special.
Vec3 slanted(double x, double y) { return Vec3(1, 2, 3) + x * Vec3(1, 1, 0) + y * Vec3(-1, 1, 1); }
const double kScale = Vec3(1, 1, 0).cross(Vec3(-1, 1, 1)).norm();

// A correct triangulation of a simple polygon covers its area once: the absolute areas add up to
// it.
void checkArea(const TriangleMesh& mesh, double expected) {
  CHECK(mesh.triangles.size() == mesh.points.size() - 2);
  CHECK(area(mesh) == doctest::Approx(expected * kScale));
}

}  // namespace

TEST_CASE("a convex polygon becomes a fan that covers it once") {
  std::vector<Vec3> corners;
  for (int i = 0; i < 12; ++i)
    corners.push_back(
        slanted(std::cos(i * std::numbers::pi / 6), std::sin(i * std::numbers::pi / 6)));
  checkArea(filled(corners), 3);  // 12 triangles of 1/2 sin 30 degrees
  CHECK(filled(corners).triangles[0] == Triangle{0, 1, 2});
}

TEST_CASE("concave polygons are covered once, whichever corner comes first") {
  const std::vector<std::pair<double, double>> shapes[] = {
      {{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}},                          // notch: 16 - 6
      {{0, 0}, {5, 0}, {5, 1}, {1, 1}, {1, 2}, {5, 2}, {5, 3}, {0, 3}},  // a C: 11
      {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 3}, {2, 1}, {1, 1}, {0, 3}},  // flat corners
  };
  const double areas[] = {10, 11, 5};
  for (int s = 0; s < 3; ++s)
    for (std::size_t first = 0; first < shapes[s].size(); ++first) {
      std::vector<Vec3> corners;
      for (std::size_t i = 0; i < shapes[s].size(); ++i) {
        const auto& [x, y] = shapes[s][(first + i) % shapes[s].size()];
        corners.push_back(slanted(x, y));
      }
      checkArea(filled(corners), areas[s]);
      std::reverse(corners.begin(), corners.end());
      checkArea(filled(corners), areas[s]);
    }
}

TEST_CASE("the triangles look the way the polygon does") {
  const TriangleMesh mesh =
      filled({slanted(0, 0), slanted(4, 0), slanted(4, 4), slanted(2, 1), slanted(0, 4)});
  const Vec3 up = Vec3(1, 1, 0).cross(Vec3(-1, 1, 1));
  for (const auto& [a, b, c] : mesh.triangles)
    CHECK((mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]).dot(up) > 0);
}

TEST_CASE("polygons without area still give their number of triangles, and too few corners none") {
  CHECK(filled({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).triangles.size() == 2);
  CHECK(filled({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}).triangles.size() == 2);
  // A bow tie crosses itself.
  CHECK(filled({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).triangles.size() == 2);
  CHECK(filled({{0, 0, 0}, {1, 0, 0}}).triangles.empty());
  CHECK(filled({}).triangles.empty());
}
