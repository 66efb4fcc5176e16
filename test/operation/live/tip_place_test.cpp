#include "operation/live/tip_place.h"

#include <doctest/doctest.h>

#include "support/block_organ.h"
#include "support/elastic_block.h"
#include "support/test_tools.h"

using namespace resect;

namespace {

constexpr double kSpacing = 0.005;

void stepAt(Simulation& simulation, const Pose& pose) {
  FrameInput input;
  input.tools = {{pose}};
  simulation.step(input);
}

Simulation stillBlock() {
  std::vector<std::unique_ptr<Tool>> tools;
  tools.push_back(test::boxTool({{-0.004, -0.004, 0}, {0.004, 0.004, 0.05}}));
  Simulation simulation(makeOrgan(test::fullBlock({12, 8, 12}, kSpacing), {}), std::move(tools));
  simulation.keepLook();
  stepAt(simulation, test::kAway);
  return simulation;
}

}  // namespace

TEST_CASE("the tip knows what lies under it and how near tissue is") {
  const Simulation simulation = stillBlock();
  const Aabb box = simulation.organ().rest.lattice.box();
  const Vec3 top(box.centre().x(), box.max.y(), box.centre().z());
  const auto placeAt = [&](const Vec3& tip) { return placeOf(presentSurface(simulation), tip); };
  const TipPlace above = placeAt(top + Vec3(0, 0.012, 0));
  // The surface of a full block ends with its cells; the nearest vertex is at most a node away.
  CHECK(above.below == doctest::Approx(top.y()).epsilon(0.05));
  CHECK(above.distance == doctest::Approx(0.012).epsilon(0.1));
  const TipPlace inside = placeAt(top - Vec3(0, 0.006, 0));
  CHECK(inside.distance == 0);
  CHECK(inside.below == doctest::Approx(top.y() - 0.006));
  const TipPlace beside = placeAt(Vec3(box.max.x() + 0.2, top.y(), top.z()));
  CHECK(beside.below == 0);
  CHECK(beside.distance == doctest::Approx(kTipReach));
  const TipPlace under = placeAt(Vec3(top.x(), box.min.y() - 0.01, top.z()));
  CHECK(under.below == 0);  // what hangs over the tip does not lie under it
}

TEST_CASE("of tissue that has moved the tip sees where it is now, not where it was") {
  Simulation simulation = test::elasticBlock(
      {7, 4, 7}, 0.01, test::boxTool({{-0.012, -0.012, 0}, {0.012, 0.012, 0.05}}, "baton", ""));
  simulation.keepLook();
  for (int i = 0; i < 120; ++i) stepAt(simulation, test::kAway);
  const Vec3 over(0.035, 0.06, 0.035);
  const double before = placeOf(presentSurface(simulation), over).below;
  CHECK(before == doctest::Approx(0.04).epsilon(0.05));
  for (int i = 0; i < 120; ++i)
    stepAt(simulation, {Vec3(0.035, 0.04 - 0.006 * std::min(1.0, i / 60.0), 0.035),
                        Eigen::Quaterniond(Eigen::AngleAxisd(-M_PI / 2, Vec3::UnitX()))});
  const TipPlace now = placeOf(presentSurface(simulation), over);
  CHECK(now.below < before - 0.003);
  // Straight down, by the slow way: the highest vertex near the plumb line.
  float highest = 0;
  for (const Vec3f& p : simulation.surfacePoints())
    if (std::hypot(p.x() - 0.035f, p.z() - 0.035f) < 0.004f) highest = std::max(highest, p.y());
  CHECK(now.below == doctest::Approx(double(highest)).epsilon(0.05));
}
