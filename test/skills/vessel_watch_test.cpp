#include "skills/attempt/vessel_watch.h"

#include <doctest/doctest.h>

#include "anatomy/small_vessels.h"
#include "support/block_organ.h"

using namespace resect;

TEST_CASE("places that heat has closed are no clips") {
  Discretization cells = test::fullBlock({12, 6, 12});
  cells.lattice.origin = Vec3::Constant(0.0025);
  Organ organ = makeOrgan(std::move(cells), {});
  organ.map = makeVesselMap(test::straightVessel(
      VesselKind::PortalVein, Vec3(-0.02, 0.0151, 0.0301), Vec3(0.05, 0.0151, 0.0301), 0.001));
  Simulation simulation(std::move(organ), {});
  VesselWatch watch;
  Attempt attempt;
  const auto step = [&](TissueEdit edit) {
    FrameInput input;
    input.edits = {std::move(edit)};
    watch.add(simulation, simulation.step(input), attempt);
  };
  for (int i = 0; i < 240; ++i) step({0, -1, Heat{Vec3(0.032, 0.0151, 0.0301), 0.004, 40}});
  REQUIRE(simulation.organ().vessels.clips.size() > 1);
  CHECK(attempt.clips.empty());
  step({0, -1, PlaceClip{0, 0.2}});
  REQUIRE(attempt.clips.size() == 1);
  CHECK(attempt.clips[0].place.x() == doctest::Approx(-0.02 + 0.2 * 0.07));
  CHECK(attempt.clips[0].vessel == "portal vein");
  CHECK(attempt.clips[0].diameter == doctest::Approx(0.002));
}
