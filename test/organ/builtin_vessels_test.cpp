#include <doctest/doctest.h>

#include "anatomy/growth/vessel_growth.h"
#include "anatomy/measure_anatomy.h"
#include "organ/builtin/builtin_liver.h"

using namespace resect;

TEST_CASE("the built-in liver's vessels of five seeds reach their terminals and cross nowhere") {
  const TriangleMesh liver = builtinLiver(0.004);
  VesselGrowth growth = builtinLiverVessels();
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
