#include <doctest/doctest.h>

#include "anatomy/growth/vessel_growth.h"
#include "anatomy/measure_anatomy.h"
#include "anatomy/plausible_segments.h"
#include "anatomy/visible_human.h"
#include "geometry/pose.h"
#include "geometry/rotation.h"
#include "organ/builtin/builtin_liver.h"

using namespace resect;

namespace {

void checkFiveSeeds(const TriangleMesh& liver, VesselGrowth growth) {
  for (growth.seed = 1; growth.seed <= 5; ++growth.seed) {
    CAPTURE(growth.seed);
    const AnatomyMeasures m = measure(growVessels(liver, growth), liver);
    for (int a = 0; a < kVesselKinds; ++a) {
      CAPTURE(a);
      const VesselMeasures& kind = m.kinds[std::size_t(a)];
      CHECK(kind.terminals >= (a < 2 ? 1000 : 990));
      CHECK(kind.outside == 0);
      for (int b = 0; b < a; ++b) CHECK(m.crossings[std::size_t(a)][std::size_t(b)] == 0);
      for (std::size_t o = 1; o < kind.radiusByOrder.size(); ++o)
        CHECK(kind.radiusByOrder[o] > kind.radiusByOrder[o - 1]);
    }
  }
}

}  // namespace

TEST_CASE("the built-in liver's vessels of five seeds reach their terminals and cross nowhere") {
  checkFiveSeeds(builtinLiver(0.004), builtinLiverVessels());
}

TEST_CASE("so do those of the Visible Human's liver") {
  if (const auto liver = test::visibleHumanLiver())
    checkFiveSeeds(*liver, test::visibleHumanVessels());
}

TEST_CASE("the built-in liver's segments are plausible with the vessels of five seeds") {
  const TriangleMesh liver = builtinLiver(0.004);
  VesselGrowth growth = builtinLiverVessels();
  for (growth.seed = 1; growth.seed <= 5; ++growth.seed) {
    CAPTURE(growth.seed);
    test::checkPlausible(growVessels(liver, growth), liver);
  }
}

TEST_CASE("the segments of the Visible Human's liver are plausible too") {
  const auto liver = test::visibleHumanLiver();
  if (!liver) return;
  VesselGrowth growth = test::visibleHumanVessels();
  for (growth.seed = 1; growth.seed <= 5; ++growth.seed) {
    CAPTURE(growth.seed);
    test::checkPlausible(growVessels(*liver, growth), *liver);
  }
}

TEST_CASE("a liver that is turned and moved keeps its segments and the names of its vessels") {
  const TriangleMesh liver = builtinLiver(0.004);
  const Anatomy before = growVessels(liver, builtinLiverVessels());
  const auto found = LiverSegments::find(before);
  REQUIRE(found);
  const test::SegmentGrid grid(*found, liver);
  for (const auto& [axis, angle] :
       {std::pair(Vec3(1, 2, -0.5), 2.1), std::pair(Vec3(-1, 0, 3), 0.7)}) {
    const Pose pose{Vec3(0.3, -1, 2), rotationAbout(axis.normalized(), angle)};
    const Anatomy after = transformed(before, pose);
    const auto again = LiverSegments::find(after);
    REQUIRE(again);
    std::size_t other = 0;
    for (std::size_t i = 0; i < grid.segments.size(); ++i)
      if (grid.segments[i] > 0 && again->at(pose * grid.place(i)) != grid.segments[i]) ++other;
    CHECK(other == 0);
    for (std::size_t i = 0; i < after.segments.size(); ++i)
      CHECK(again->nameOf(after, std::int32_t(i)) == found->nameOf(before, std::int32_t(i)));
  }
}
