// Wrong arguments of public functions give an Error, in one sentence.
#include <doctest/doctest.h>

#include "haptics/bench/haptics_bench.h"
#include "haptics/local_model.h"
#include "support/elastic_block.h"
#include "support/sentence.h"
#include "support/test_tools.h"

using namespace resect;

TEST_CASE("wrong arguments of haptics are refused") {
  Simulation simulation = test::elasticBlock(
      {4, 4, 4}, 0.008,
      test::describedTool("baton", sphereMesh(Vec3::Zero(), 0.005, 16), [](ToolModel&) {}));
  LocalModels models;
  CHECK(test::refuses([&] { models.make(simulation, 1, 0.01); }, "tool 1"));
  CHECK(test::refuses([&] { models.make(simulation, 0, 0); }, "0 s"));
  CHECK(test::refuses([] { makeLocalModel({{}, {}, -1, Vec3::Zero(), 0.3}, {}); }, "-1 s"));
  CHECK(test::refuses([] { ForceRenderer(-2); }, "-2 N"));
  const HapticPlugin plugin(findHapticPlugin("simulated_hand"));
  Scenario scenario;
  scenario.tools.resize(1);
  CHECK(test::refuses([&] { benchHaptics(simulation, scenario, plugin, {0, "", ""}); }, "0 s"));
  CHECK(test::refuses(
      [&] {
        benchHaptics(simulation, scenario, plugin, {2, "", ""});
      },
      "moves no instrument"));
  CHECK(models.make(simulation, 0, 0.01).inHand == false);
}
