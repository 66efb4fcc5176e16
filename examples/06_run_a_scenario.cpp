// 06: a whole operation from a scenario, as `resect run` does it.
//
// A scenario says which organ, which instruments, and where they are when; docs/scenarios.md lists
// its keys. Run twice, at different numbers of threads, it gives the same state bit for bit.

#include <fmt/core.h>

#include "base/parallel.h"
#include "base/state/state_hash.h"
#include "inventor/reading/model_file.h"
#include "io/operation_setup.h"
#include "io/scenario/scenario_file.h"
#include "operation/run.h"

using namespace resect;

// Instruments are those that come with Resect; so is the organ.
constexpr const char* kScenario = R"(
title = "A baton pushed through the built-in liver"
duration = 0.5
[organ]
source = "liver"
spacing = "8mm"
[[tool]]
model = "baton"
keys = [
  { time = 0.1, position = [0, 0.30, 0], rotation = { axis = [1, 0, 0], degrees = -90 } },
  { time = 0.4, position = [0, 0.02, 0], rotation = { axis = [1, 0, 0], degrees = -90 } },
]
)";

RunSummary runWith(int threads) {
  const ThreadLimit limit(threads);
  const Scenario scenario = parseScenario(kScenario, "example");
  Organ organ = makeOrgan(loadCells(scenario.organs[0].source, readModel),
                          scenario.organs[0].source.settings);
  std::unique_ptr<TissueModel> tissue = makeTissue(scenario.organs[0].tissue, organ);
  Simulation simulation(std::move(organ), loadTools(scenario, readModel), std::move(tissue),
                        scenario.table);
  return runScenario(simulation, scenario,
                     [](const Simulation&, const FrameInput&, const StepReport& report) {
                       if (report.removed > 0)
                         fmt::print("{:.3f} s: {} particles, {:.2f} ml\n", report.time,
                                    report.removed, 1e6 * report.removedVolume);
                       return true;
                     });
}

int main() {
  const RunSummary first = runWith(1), second = runWith(2);
  for (const StageTimes& stage : first.stages)
    fmt::print("{:<14} {:.2f} ms\n", stage.name, 1e3 * summarise(stage.seconds).total);
  const TissueAmount removed = first.ledger.tissue().removed;
  fmt::print("{} of {} particles removed in {} frames, surface {}\n", removed.particles,
             first.ledger.tissue().before.particles, first.frames,
             first.surface.closed ? "closed" : "open");
  fmt::print("state with one thread {:016x}, with two {:016x}\n", first.stateHash,
             second.stateHash);
  return removed.particles > 0 && first.surface.closed && first.stateHash == second.stateHash ? 0
                                                                                              : 1;
}
