#include "geometry/ray.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/random.h"
#include "geometry/primitives.h"

using namespace resect;

namespace {

Vec3 anyPoint(Random& random, double most) {
  return {random.uniform(-most, most), random.uniform(-most, most), random.uniform(-most, most)};
}

double firstMeeting(const Ray& ray, const TriangleMesh& mesh) {
  double first = std::numeric_limits<double>::infinity();
  for (const Triangle& t : mesh.triangles)
    first = std::min(first, resect::firstMeeting(ray, mesh.points[std::size_t(t[0])],
                                                 mesh.points[std::size_t(t[1])],
                                                 mesh.points[std::size_t(t[2])]));
  return first;
}

}  // namespace

TEST_CASE("a ray meets a triangle where it goes through it, from either side, and not behind it") {
  const Vec3 a(0, 0, 0), b(2, 0, 0), c(0, 2, 0);
  for (const double side : {1.0, -1.0}) {
    const Ray ray{Vec3(0.5, 0.5, 3 * side), Vec3(0, 0, -2 * side)};
    CHECK(firstMeeting(ray, a, b, c) == doctest::Approx(1.5));
    CHECK(std::isinf(firstMeeting({ray.origin, -ray.direction}, a, b, c)));
  }
  CHECK(std::isinf(firstMeeting({Vec3(1.1, 1.1, 3), Vec3(0, 0, -1)}, a, b, c)));
  CHECK(std::isinf(firstMeeting({Vec3(-0.1, 0.5, 3), Vec3(0, 0, -1)}, a, b, c)));
  CHECK(std::isinf(firstMeeting({Vec3(-1, 0.5, 0), Vec3(1, 0, 0)}, a, b, c)));  // in its plane
  CHECK(std::isinf(firstMeeting({Vec3(0.5, 0.5, 3), Vec3(0, 0, -1)}, a, b, b)));
}

TEST_CASE(
    "a ray from a box's inside leaves it where its faces are, through edges and corners too") {
  const Aabb box{{-0.3, -0.2, -0.1}, {0.4, 0.5, 0.6}};
  const TriangleMesh mesh = boxMesh(box);
  Random random(3);
  for (int i = 0; i < 3000; ++i) {
    const Vec3 origin = 0.09 * anyPoint(random, 1);
    Vec3 to = anyPoint(random, 1);
    // Every second one through a corner or through the edge, or the diagonal, between two.
    if (i % 2) to = box.corner(i % 8), to += random.uniform(0, 1) * (box.corner(i / 8 % 8) - to);
    const Vec3 way = to - origin;
    double expected = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
      if (way[axis] != 0)
        expected = std::min(expected,
                            ((way[axis] > 0 ? box.max : box.min)[axis] - origin[axis]) / way[axis]);
    CHECK(firstMeeting({origin, way}, mesh) == doctest::Approx(expected).epsilon(1e-9));
  }
}

TEST_CASE("a ray meets a box if and only if it meets its faces or begins inside") {
  const Aabb box{{-0.3, -0.2, -0.1}, {0.4, 0.5, 0.6}};
  const TriangleMesh mesh = boxMesh(box);
  Random random(5);
  int met = 0;
  for (int i = 0; i < 3000; ++i) {
    Ray ray{anyPoint(random, 1), anyPoint(random, 1)};
    if (i % 3 == 0) ray.direction[i % 2] = 0;
    const bool expected = box.contains(ray.origin) || std::isfinite(firstMeeting(ray, mesh));
    CHECK(meets(ray, box) == expected);
    met += expected;
  }
  CHECK(met > 300);
  CHECK(met < 2700);
  CHECK_FALSE(meets(Ray{Vec3(0, 0, 0), Vec3(1, 0, 0)}, Aabb{}));
}
