// What it costs to follow an attempt while somebody works on it, per frame of 1/60 s.
#include <benchmark/benchmark.h>

#include <chrono>

#include "io/data_folder.h"
#include "io/operation_setup.h"
#include "io/plain_mesh.h"
#include "io/scenario/scenario_file.h"
#include "skills/live/live_attempt.h"

using namespace resect;

namespace {

// The reference run of a task again and again; counted is the follower alone.
void followAttempt(benchmark::State& state, const std::string& task) {
  Scenario scenario = readScenario(dataFolder() / "tasks" / (task + ".toml"));
  Simulation simulation = makeSimulation(scenario, readPlainMesh);
  const std::int64_t frames = frameCount(scenario);
  const Bytes begun = simulation.save();
  StepReport report;
  std::int64_t frame = 0;
  OperationWatch watch;
  double most = 0;
  for (auto _ : state) {
    if (frame % frames == 0) {
      simulation.restore(begun);
      watch = std::make_shared<LiveAttempt>(scenario, simulation)->watch({});
      frame = 0;
    }
    simulation.step(frameInput(scenario, frame), report);
    const auto before = std::chrono::steady_clock::now();
    watch.stepped({0, ++frame}, {}, report, {}, simulation);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - before;
    state.SetIterationTime(took.count());
    most = std::max(most, took.count());
  }
  state.counters["most_ms"] = 1e3 * most;
}

}  // namespace

int main(int argc, char** argv) {
  for (const std::string& task : shippedNames("tasks", ".toml"))
    benchmark::RegisterBenchmark(("follow " + task).c_str(), followAttempt, task)
        ->UseManualTime()
        ->Unit(benchmark::kMicrosecond)
        ->Iterations(600);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
