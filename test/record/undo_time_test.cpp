// How long a stroke takes to be taken back, in an operation as people have it.
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "io/data_folder.h"
#include "io/operation_setup.h"
#include "io/plain_mesh.h"
#include "io/scenario/scenario_file.h"
#include "operation/live/operation_history.h"

using namespace resect;

TEST_CASE("a stroke in 13 000 elastic particles is taken back and done again at once") {
  Scenario scenario = readScenario(findDataFile("press", "scenarios", ".toml"));
  setSpacing(scenario, *scenario.organs[0].source.spacing, 0.005);
  Simulation simulation = makeSimulation(scenario, readPlainMesh);
  CHECK(simulation.organ().particles > 12'000);
  OperationHistory history(simulation, scenario.frameRate);
  StepReport report;
  std::vector<std::uint64_t> way{simulation.stateHash()};
  for (int i = 0; i < 200; ++i) {
    const FrameInput input = frameInput(scenario, i);
    history.beforeStep(input, simulation);
    simulation.step(input, report);
    history.afterStep(input, report, simulation);
    way.push_back(simulation.stateHash());
  }
  REQUIRE(history.undoable() == 1);
  std::vector<double> times;
  const auto timed = [&](auto act) {
    const auto begin = std::chrono::steady_clock::now();
    act();
    times.push_back(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  };
  for (int i = 0; i < 5; ++i) {
    timed([&] {
      const Moment from = history.now();
      history.goTo(history.undoMoment().value(), simulation);
      history.undone(from);
    });
    CHECK(simulation.stateHash() == way[std::size_t(simulation.frame())]);
    timed([&] {
      history.goTo(history.redoMoment().value(), simulation);
      history.redone();
    });
    CHECK(simulation.stateHash() == way.back());
  }
  std::ranges::sort(times);
  MESSAGE("undo and redo: median " << 1000 * times[times.size() / 2] << " ms, worst "
                                   << 1000 * times.back() << " ms");
  CHECK(times[times.size() / 2] < 0.5);  // 0.1 s where nothing else runs
}
