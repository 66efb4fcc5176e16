#include "geometry/rotation.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/random.h"

using namespace resect;

namespace {

Eigen::Quaterniond anyRotation(Random& random) {
  Eigen::Quaterniond q(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1),
                       random.uniform(-1, 1));
  return q.normalized();
}

}  // namespace

TEST_CASE("rotations are Eigen's to within rounding") {
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Quaterniond a = anyRotation(random), b = anyRotation(random);
    const double angle = random.uniform(-10, 10), share = random.uniform();
    const Vec3 axis = a * Vec3::UnitX();
    CHECK(rotationAbout(axis, angle)
              .isApprox(Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis)), 1e-14));
    CHECK(std::abs(angleBetween(a, b) - a.angularDistance(b)) < 1e-14);
    CHECK(slerp(a, b, share).isApprox(a.slerp(share, b), 1e-13));
    const Eigen::AngleAxisd turn(a);
    CHECK((rotationVector(a) - turn.angle() * turn.axis()).norm() < 1e-13);
  }
}

TEST_CASE("rotations that hardly turn, not at all or by half a turn") {
  const Eigen::Quaterniond none = Eigen::Quaterniond::Identity();
  CHECK(rotationVector(none) == Vec3(0, 0, 0));
  CHECK(angleBetween(none, none) == 0);
  CHECK(slerp(none, none, 0.3).coeffs() == none.coeffs());
  CHECK(rotationVector(rotationAbout(Vec3::UnitY(), 1e-12)).y() ==
        doctest::Approx(1e-12).epsilon(1e-12));
  CHECK(std::abs(rotationVector(rotationAbout(Vec3::UnitZ(), 3.1415926)).z()) ==
        doctest::Approx(3.1415926));
  // The shorter way: the same orientation written with the other sign.
  Eigen::Quaterniond other = rotationAbout(Vec3::UnitX(), 0.2);
  other.coeffs() *= -1;
  CHECK(angleBetween(none, other) == doctest::Approx(0.2));
  CHECK(angleBetween(none, slerp(none, other, 0.5)) == doctest::Approx(0.1));
  CHECK(slerp(none, rotationAbout(Vec3::UnitX(), 1e-9), 0.5).norm() == doctest::Approx(1));
}
