#include "geometry/normals.h"

#include <doctest/doctest.h>

#include <cmath>

#include "geometry/primitives.h"

using namespace resect;

TEST_CASE("the normals of a sphere point away from its centre") {
  const Vec3 centre(0.3, -0.2, 0.1);
  const TriangleMesh sphere = sphereMesh(centre, 0.1, 24);
  const std::vector<Vec3> normals = pointNormals(sphere);
  REQUIRE(normals.size() == sphere.points.size());
  // A chord of 180 / 24 degrees is off its tangent by half of that at most.
  for (std::size_t i = 0; i < normals.size(); ++i)
    CHECK(normals[i].dot((sphere.points[i] - centre).normalized()) > std::cos(3.75 / 57.29578));
}

TEST_CASE("how a flat side is cut into triangles does not tilt the normal of a box's corner") {
  const TriangleMesh box = boxMesh({{-1, -1, -1}, {1, 1, 1}});
  const std::vector<Vec3> normals = pointNormals(box);
  for (std::size_t i = 0; i < normals.size(); ++i)
    CHECK(normals[i].isApprox(box.points[i].normalized(), 1e-12));
}

TEST_CASE("points without triangles and triangles without area get the normal +Y") {
  const TriangleMesh mesh{{Vec3::Zero(), Vec3::UnitX(), 2 * Vec3::UnitX()}, {{0, 1, 2}}};
  for (const Vec3& n : pointNormals(mesh)) CHECK(n == Vec3::UnitY());
}
