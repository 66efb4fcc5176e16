#include <doctest/doctest.h>

#include "anatomy/growth/vessel_growth.h"
#include "anatomy/measure_anatomy.h"
#include "anatomy/visible_human.h"
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
  const auto liver = test::visibleHumanLiver();
  if (!liver) return;
  VesselGrowth growth;  // where its portal vein enters, and its hepatic veins meet
  growth.hilum = Vec3(0.000, 0.333, 0.028);
  growth.hilumOut = Vec3(0.010, 0.290, 0.020);
  growth.cava = Vec3(-0.029, 0.423, -0.007);
  growth.cavaOut = Vec3(-0.029, 0.450, -0.040);
  checkFiveSeeds(*liver, growth);
}
