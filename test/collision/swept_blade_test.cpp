#include "collision/swept_blade.h"

#include <doctest/doctest.h>

#include <numbers>

#include "base/random.h"
#include "support/random_point.h"

using namespace resect;

namespace {

Pose at(const Vec3& p) { return {p, Eigen::Quaterniond::Identity()}; }

// An edge of 5 cm along z with a belly, of 8 points.
std::vector<Vec3> curvedEdge() {
  std::vector<Vec3> edge;
  for (int i = 0; i < 8; ++i) {
    const double z = 0.05 * i / 7;
    edge.push_back({0, -0.004 * std::sin(std::numbers::pi * z / 0.05), z});
  }
  return edge;
}

}  // namespace

TEST_CASE("a straight edge that moves sideways crosses the segments through its rectangle") {
  const std::vector<Vec3> edge = {{0, 0, 0}, {0, 0, 0.05}};
  const SweptBlade blade = sweepBlade(edge, at({0, 0, 0}), at({0.02, 0, 0}));
  REQUIRE(blade.triangles.size() == 2);
  const auto hit = crossing(blade, {0.01, 0.003, 0.02}, {0.01, -0.001, 0.02});
  REQUIRE(hit);
  CHECK(hit->share == doctest::Approx(0.75));
  CHECK(!crossing(blade, {0.01, 0.003, 0.02}, {0.01, 0.001, 0.02}));   // above
  CHECK(!crossing(blade, {0.021, 0.003, 0.02}, {0.021, -0.1, 0.02}));  // ahead
  CHECK(!crossing(blade, {0.01, 0.003, 0.051}, {0.01, -0.1, 0.051}));  // past the heel
}

TEST_CASE("an edge that rests, moves along itself, or has one point sweeps nothing") {
  const std::vector<Vec3> edge = {{0, 0, 0}, {0, 0, 0.05}};
  CHECK(sweepBlade(edge, at({1, 2, 3}), at({1, 2, 3})).empty());
  CHECK(sweepBlade(edge, at({0, 0, 0}), at({0, 0, 0.01})).empty());
  CHECK(sweepBlade(std::vector<Vec3>{{0, 0, 0}}, at({0, 0, 0}), at({0.01, 0, 0})).empty());
  CHECK(sweepBlade({}, at({0, 0, 0}), at({0.01, 0, 0})).empty());
}

TEST_CASE(
    "nothing slips through the seams of a strip: 20 000 segments aimed at seams and corners") {
  Random random(3);
  const std::vector<Vec3> edge = curvedEdge();
  for (int motion = 0; motion < 20; ++motion) {
    const Pose from{test::randomPoint(random, 0.1),
                    Eigen::Quaterniond(1, 0.2, 0.1, -0.3).normalized()};
    // Ahead of the edge and a little round; the strip is nearly flat in the middle.
    const Pose to{from.position + from.rotation * Vec3(0.012, 0.003, 0.001),
                  from.rotation * Eigen::Quaterniond(Eigen::AngleAxisd(0.1, Vec3::UnitY()))};
    const SweptBlade blade = sweepBlade(edge, from, to);
    int missed = 0;
    for (int i = 0; i < 1000; ++i) {
      const BladeTriangle& t = blade.triangles[random.below(int(blade.triangles.size()))];
      // On the common side of two triangles of a quadrilateral.
      const double s = random.uniform(0.01, 0.99);
      const Vec3 seam = (1 - s) * t.corner + s * (i % 2 ? t.otherU : t.otherV);
      const Vec3 up = t.normal + 0.3 * test::randomPoint(random, 1);
      const Vec3 p = seam + 0.003 * up, q = seam - 0.002 * up;
      missed += !crossing(blade, p, q);
    }
    CHECK(missed == 0);
  }
}

TEST_CASE("a point in the plane of the sweep keeps the segments on one of its sides") {
  const std::vector<Vec3> edge = {{0, 0, 0}, {0, 0, 0.05}};
  const SweptBlade blade = sweepBlade(edge, at({0, 0, 0}), at({0.02, 0, 0}));
  const Vec3 on(0.01, 0, 0.025), above(0.01, 0.005, 0.025), below(0.01, -0.005, 0.025);
  CHECK(bool(crossing(blade, on, above)) + bool(crossing(blade, on, below)) == 1);
  CHECK(!crossing(blade, on, Vec3(0.011, 0, 0.025)));
}

TEST_CASE("the sweep of a turning edge stays within its flatness of the edge's path") {
  const std::vector<Vec3> edge = {{0.04, 0, 0}, {0.04, 0, 0.02}};
  const Pose from = at({0, 0, 0});
  const Pose to{Vec3::Zero(), Eigen::Quaterniond(Eigen::AngleAxisd(2.5, Vec3::UnitZ()))};
  const SweptBlade blade = sweepBlade(edge, from, to, 1e-5);
  for (const BladeTriangle& t : blade.triangles) {
    CHECK(t.corner.head<2>().norm() == doctest::Approx(0.04));
    CHECK((0.5 * (t.corner + t.otherU)).head<2>().norm() > 0.04 - 1e-5);
    CHECK((0.5 * (t.corner + t.otherV)).head<2>().norm() > 0.04 - 1e-5);
  }
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    const double angle = random.uniform(0.01, 2.49);
    const Vec3 d(std::cos(angle), std::sin(angle), 0);
    CHECK(crossing(blade, 0.039 * d + Vec3(0, 0, 0.01), 0.041 * d + Vec3(0, 0, 0.01)));
  }
}
