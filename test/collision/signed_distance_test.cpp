#include "collision/signed_distance.h"

#include <doctest/doctest.h>

#include "base/random.h"
#include "geometry/primitives.h"
#include "support/random_point.h"

using namespace resect;

TEST_CASE("the distance to a ball is that of its formula, inside and outside") {
  const double radius = 0.01;
  const SignedDistance ball(sphereMesh({0.001, 0, 0}, radius, 64), 0.008, 0.0005);
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = test::randomPoint(random, 0.014), from = p - Vec3(0.001, 0, 0);
    const auto sample = ball(p);
    // Nodes near the surface are exact; further off the nearest triangle is handed on.
    const bool near = std::abs(from.norm() - radius) < 0.001;
    CHECK(std::abs(sample.distance - (from.norm() - radius)) < (near ? 1e-4 : 4e-4));
    if (near) CHECK(sample.outwards.dot(from.normalized()) > 0.99);
    if (from.norm() > 0.003) CHECK(sample.outwards.dot(from.normalized()) > 0.9);
  }
  CHECK(ball({1, 0, 0}).distance == SignedDistance::kFar);
}

TEST_CASE("the distance to a box is exact on flat sides, and its faces look outwards") {
  const SignedDistance box(boxMesh({{-0.002, -0.01, 0}, {0.002, 0.01, 0.05}}), 0.01, 0.001);
  CHECK(box({0.006, 0, 0.02}).distance == doctest::Approx(0.004).epsilon(1e-6));
  CHECK(box({0.0015, 0, 0.02}).distance == doctest::Approx(-0.0005).epsilon(1e-3));
  CHECK(box({0.006, 0, 0.02}).outwards.x() == doctest::Approx(1));
  CHECK(box({0, -0.013, 0.02}).outwards.y() == doctest::Approx(-1));
}

TEST_CASE("nothing is near an empty body") {
  CHECK(SignedDistance({}, 0.01, 0.001)({0, 0, 0}).distance == SignedDistance::kFar);
}
