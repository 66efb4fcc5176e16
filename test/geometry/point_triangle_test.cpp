#include "geometry/point_triangle.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/random.h"
#include "support/random_point.h"
#include "support/references/mesh_reference.h"

using namespace resect;

TEST_CASE("the distance to a right triangle is exact over its face, beside its edges and corners") {
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  CHECK(squaredDistance({0.2, 0.3, 0.5}, a, b, c) == doctest::Approx(0.25));
  CHECK(squaredDistance({0.2, 0.3, 0}, a, b, c) == doctest::Approx(0));
  CHECK(squaredDistance({0.5, -2, 0}, a, b, c) == doctest::Approx(4));
  CHECK(squaredDistance({1, 1, 0}, a, b, c) == doctest::Approx(0.5));
  CHECK(squaredDistance({-1, -1, 1}, a, b, c) == doctest::Approx(3));
  CHECK(squaredDistance({3, 0, 0}, a, b, c) == doctest::Approx(4));
  CHECK(squaredDistance({0, 4, 0}, a, b, c) == doctest::Approx(9));
}

TEST_CASE("the distance to any triangle is the plain reference's") {
  Random random(8);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 a = test::randomPoint(random, 1), b = test::randomPoint(random, 1),
               c = test::randomPoint(random, 1), p = test::randomPoint(random, 2);
    CHECK(std::sqrt(squaredDistance(p, a, b, c)) ==
          doctest::Approx(test::distanceToTriangle(p, a, b, c)).epsilon(1e-9));
  }
}
