#include "operation/scenario.h"

#include <doctest/doctest.h>

#include <cmath>

#include "operation/run.h"
#include "support/block_organ.h"
#include "support/test_tools.h"

using namespace resect;

namespace {

ToolKey key(double time, const Vec3& p) { return {time, {p, Eigen::Quaterniond::Identity()}}; }

}  // namespace

TEST_CASE("a tool moves linearly between its keys and lies in the box before and after") {
  ScenarioTool tool;
  tool.rest.position = Vec3(9, 9, 9);
  tool.keys = {key(1, {0, 0, 0}), key(2, {1, 0, 0}), key(4, {1, 2, 0})};
  CHECK_FALSE(toolInputAt(tool, 0.5).inHand);
  CHECK(toolInputAt(tool, 0.5).pose.position == tool.rest.position);
  CHECK(toolInputAt(tool, 1).inHand);
  CHECK((toolInputAt(tool, 1.25).pose.position - Vec3(0.25, 0, 0)).norm() < 1e-12);
  CHECK((toolInputAt(tool, 3).pose.position - Vec3(1, 1, 0)).norm() < 1e-12);
  CHECK((toolInputAt(tool, 4).pose.position - Vec3(1, 2, 0)).norm() < 1e-12);
  CHECK_FALSE(toolInputAt(tool, 4.1).inHand);
  CHECK_FALSE(toolInputAt(ScenarioTool{}, 1).inHand);
}

TEST_CASE("a scenario runs all its frames and its summary adds up") {
  Scenario scenario;
  scenario.frameRate = 30;
  scenario.duration = 1;
  ScenarioTool tool;
  tool.rest.position = Vec3(2, 2, 2);
  const Discretization cells = test::ball(20);
  const Vec3 middle = cells.lattice.box().centre();
  tool.keys = {key(0.1, middle - Vec3(0.1, 0, 0)), key(0.9, middle + Vec3(0.1, 0, 0))};
  scenario.tools = {tool};
  std::vector<std::unique_ptr<Tool>> tools;
  tools.push_back(test::ballTool(0.01));
  Simulation simulation(makeOrgan(cells, {}), std::move(tools));
  int observed = 0;
  const RunSummary summary = runScenario(
      simulation, scenario, [&](const Simulation&, const FrameInput&, const StepReport&) {
        ++observed;
        return true;
      });
  CHECK(summary.frames == 30);
  CHECK(observed == 30);
  CHECK(summary.simulatedSeconds == doctest::Approx(1));
  const TissueSplit tissue = summary.ledger.tissue();
  CHECK(tissue.removed.particles > 50);
  CHECK(tissue.left().particles == simulation.organ().particles);
  CHECK(discrepancy(summary.ledger, &simulation) == "");
  CHECK(summary.surface.closed);
  CHECK(summary.surface.oriented);
  CHECK(summary.ledger.organs[0].parts.size() == 1);
  CHECK(summary.stages.size() == 11);
  CHECK(summary.stateHash == simulation.stateHash());
}

TEST_CASE("the observer can stop an operation") {
  Scenario scenario;
  Simulation simulation(makeOrgan(test::ball(8), {}), {});
  CHECK(runScenario(
            simulation, scenario,
            [](const Simulation&, const FrameInput&, const StepReport& r) { return r.frame < 4; })
            .frames == 5);
}

TEST_CASE("in thesis mode tissue is still, and of two tools in hand at once the first alone is") {
  Scenario scenario;
  scenario.tools.resize(2);
  for (ScenarioTool& tool : scenario.tools) tool.keys = {{0.0, {}}, {1.0, {}}};
  makeElastic(scenario);
  CHECK(scenario.organs[0].tissue.elastic);
  FrameInput input = frameInput(scenario, 10);
  CHECK(input.tools[0].inHand);
  CHECK(input.tools[1].inHand);
  makeThesis(scenario);
  CHECK_FALSE(scenario.organs[0].tissue.elastic);
  input = frameInput(scenario, 10);
  CHECK(input.tools[0].inHand);
  CHECK_FALSE(input.tools[1].inHand);
  scenario.tools[0].keys.clear();
  CHECK(frameInput(scenario, 10).tools[1].inHand);
}

TEST_CASE("another size of cells is the first organ's, and the others' in proportion") {
  Scenario scenario;
  scenario.organs.resize(3);
  scenario.organs[0].source.dims = Vec3i(10, 20, 10);
  scenario.organs[1].source.spacing = 0.004;
  scenario.organs[2].source.dims = Vec3i(5, 5, 5);
  setSpacing(scenario, 0.006, 0.003);
  CHECK(*scenario.organs[0].source.spacing == 0.003);
  CHECK_FALSE(scenario.organs[0].source.dims);
  CHECK(*scenario.organs[1].source.spacing == doctest::Approx(0.002));
  CHECK(scenario.organs[2].source.dims);
}
