#include "operation/blood/bleeding_ends.h"

#include <doctest/doctest.h>

#include "anatomy/small_vessels.h"
#include "operation/live/operation_events.h"
#include "support/block_organ.h"
#include "support/test_tools.h"

using namespace resect;

namespace {

const Vec3 kCut(0.0321, 0.0151, 0.0301);  // where the vein is cut

// A block of 60 x 30 x 60 mm of still tissue with a vein of 4 mm along x, and an instrument far
// away.
Simulation block() {
  Discretization cells = test::fullBlock({12, 6, 12});
  cells.lattice.origin = Vec3::Constant(0.0025);
  Organ organ = makeOrgan(std::move(cells), {});
  organ.map =
      makeVesselMap(test::straightVessel(VesselKind::PortalVein, Vec3(-0.02, kCut.y(), kCut.z()),
                                         Vec3(0.05, kCut.y(), kCut.z()), 0.002));
  std::vector<std::unique_ptr<Tool>> tools;
  tools.push_back(test::boxTool({{-0.001, -0.001, 0}, {0.001, 0.001, 0.06}}, "bipolar", ""));
  return Simulation(std::move(organ), std::move(tools));
}

StepReport step(Simulation& simulation, std::vector<TissueEdit> edits = {}) {
  FrameInput input;
  input.tools = {{{Vec3(1, 1, 1), Eigen::Quaterniond::Identity()}, true}};
  input.edits = std::move(edits);
  return simulation.step(input);
}

}  // namespace

TEST_CASE("the ends that bleed are those of the report, at the vessel's end, after a restore too") {
  Simulation simulation = block(), other = block();
  CHECK(bleedingEnds(simulation).empty());
  step(simulation, {{0, -1, Incision{test::acrossX(kCut.x(), 0.01, 0.05)}}});
  StepReport report;
  for (int i = 0; i < 10; ++i) report = step(simulation);
  const std::vector<BleedingEnd> ends = bleedingEnds(simulation);
  REQUIRE(ends.size() == report.blood.ends.size());
  REQUIRE(ends.size() == 1);
  CHECK(ends[0].segment == report.blood.ends[0].segment);
  CHECK(ends[0].flow == report.blood.ends[0].flow);
  CHECK((ends[0].place - kCut).norm() < 1e-6);
  other.restore(simulation.save());
  REQUIRE(bleedingEnds(other).size() == 1);
  CHECK(bleedingEnds(other)[0].flow == ends[0].flow);
}

TEST_CASE("heat and clips are work on an organ, without any contact; taking blood is none") {
  Simulation simulation = block();
  const auto works = [&](TissueEdit edit) {
    return worksOnOrgan(step(simulation, {std::move(edit)}), simulation, 0);
  };
  CHECK_FALSE(worksOnOrgan(step(simulation), simulation, 0));
  CHECK(works({0, 0, Heat{kCut, 0.003, 10}}));
  CHECK(works({0, 0, PlaceClip{0, 0.3}}));
  CHECK(works({0, 0, Incision{test::acrossX(0.01, 0.02, 0.05)}}));
  CHECK_FALSE(works({0, -1, Heat{kCut, 0.003, 10}}));
  CHECK_FALSE(works({0, 0, Suction{kCut, 0.01, 1e-6}}));
  CHECK_FALSE(works({0, 0, Press{kCut, 0.01, 100, 1e-6}}));
  CHECK_FALSE(works({0, 0, Release{}}));
}
