#include "operation/blood/bloody_tools.h"

#include <doctest/doctest.h>

#include "operation/blood/bleeding_block.h"

using namespace resect;
using test::kCut;

TEST_CASE("an instrument becomes bloody in blood, and stays so") {
  Simulation simulation = test::bleedingBlock();
  std::vector<double> reach;
  const auto run = [&](const Pose& pose, bool inHand, int frames) {
    FrameInput input;
    input.tools = {{pose, inHand}};
    for (int i = 0; i < frames; ++i) {
      simulation.step(input);
      followBlood(simulation, reach);
    }
  };
  // The handle upwards, out of the wound; and lying over the block's top, beside the wound.
  const Eigen::Quaterniond up(Eigen::AngleAxisd(-1.5707963267948966, Vec3::UnitX()));
  const Pose inWound{kCut, up}, far{Vec3(1, 1, 1), up};
  run(inWound, true, 1);
  CHECK(reach == std::vector<double>{0});  // nothing bleeds
  FrameInput cut;
  cut.tools = {{far, true}};
  cut.edits.push_back({0, -1, Incision{test::acrossX(kCut.x(), 0.01, 0.05)}});
  simulation.step(cut);
  run(far, true, 60);
  CHECK(reach[0] == 0);  // it bleeds elsewhere
  run(inWound, true, 2);
  const double deep = reach[0];
  CHECK(deep > 0.005);
  CHECK(deep < 0.03);
  run(far, true, 2);
  CHECK(reach[0] == deep);
  run(inWound, false, 1);
  CHECK(reach[0] == deep);  // not in hand
}

TEST_CASE("a gauze swab soaks up blood beside its axis, where forceps stay clean") {
  constexpr double kHalf = 0.016;  // m: of the swab's side
  std::vector<double> reached;
  for (const bool gauze : {false, true}) {
    Simulation simulation = test::bleedingBlock(
        test::portalVeinAlongX(),
        gauze ? test::describedTool("gauze", boxMesh({{-kHalf, -kHalf, 0}, {kHalf, kHalf, 0.008}}),
                                    [](ToolModel& m) { m.contactRadius = kHalf; })
              : test::thinForceps());
    test::step(simulation, {{0, -1, Incision{test::acrossX(test::kCut.x(), 0.01, 0.05)}}});
    for (int i = 0; i < 120; ++i) test::step(simulation);
    const Eigen::Quaterniond up(Eigen::AngleAxisd(-1.5707963267948966, Vec3::UnitX()));
    std::vector<double> reach;
    FrameInput input;
    // On the block's top, 10 mm beside the cut.
    input.tools = {{{Vec3(test::kCut.x() + 0.010, 0.031, test::kCut.z()), up}, true}};
    for (int i = 0; i < 2; ++i) {
      simulation.step(input);
      followBlood(simulation, reach);
    }
    reached.push_back(reach[0]);
  }
  MESSAGE("red up to ", 1e3 * reached[0], " and ", 1e3 * reached[1], " mm");
  CHECK(reached[0] == 0);
  CHECK(reached[1] > 0.0015);
  CHECK(reached[1] <= 0.012);
}
