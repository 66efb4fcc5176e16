#include "anatomy/growth/vessel_growth.h"

#include <doctest/doctest.h>

#include <cmath>

#include "anatomy/ball_growth.h"
#include "anatomy/growth/murray.h"
#include "anatomy/measure_anatomy.h"
#include "anatomy/none_crosses.h"
#include "base/error.h"
#include "geometry/primitives.h"

using namespace resect;

namespace {

// The ball in which test::ballGrowth() lets them grow.
TriangleMesh ball() { return sphereMesh(Vec3::Zero(), 0.06); }

}  // namespace

TEST_CASE("radii grow with the number of terminals to the power of 1 / 2.8") {
  for (const double n : {1e-3, 0.5, 1.0, 2.0, 7.3, 128.0, 999.0, 5000.0})
    CHECK(murrayShare(n) == doctest::Approx(std::pow(n, 1 / 2.8)).epsilon(1e-14));
}

TEST_CASE("the vessels of any seed stay inside the organ and cross none of another kind") {
  const TriangleMesh organ = ball();
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    const Anatomy anatomy = growVessels(organ, test::ballGrowth(seed));
    const AnatomyMeasures m = measure(anatomy, organ);
    CHECK(m.kinds[0].terminals == 200);
    CHECK(m.kinds[1].terminals == 200);
    // Artery and duct reach nearly all of the portal vein's terminals.
    CHECK(m.kinds[2].terminals >= 196);
    CHECK(m.kinds[3].terminals >= 196);
    test::checkNoneCrosses(m);
    // Wider towards the root, order by order.
    for (const VesselMeasures& kind : m.kinds)
      for (std::size_t o = 1; o < kind.radiusByOrder.size(); ++o)
        CHECK(kind.radiusByOrder[o] > kind.radiusByOrder[o - 1]);
  }
}

TEST_CASE("the same seed gives the same vessels, another one gives others") {
  const TriangleMesh organ = ball();
  const auto ends = [&](std::uint64_t seed) {
    std::vector<double> all;
    for (const VesselSegment& s : growVessels(organ, test::ballGrowth(seed)).segments)
      all.insert(all.end(), {s.end.x(), s.end.y(), s.end.z(), s.radius});
    return all;
  };
  CHECK(ends(3) == ends(3));
  CHECK(ends(3) != ends(4));
}

TEST_CASE("vessels for an organ without room, or with settings out of range, are refused") {
  VesselGrowth g = test::ballGrowth(1);
  g.terminals = 10;
  CHECK_THROWS_AS(growVessels(ball(), g), Error);
  g = test::ballGrowth(1);
  g.hilum.x() = std::nan("");
  CHECK_THROWS_AS(growVessels(ball(), g), Error);
  CHECK_THROWS_AS(growVessels(sphereMesh(Vec3::Zero(), 0.002), test::ballGrowth(1)), Error);
}
