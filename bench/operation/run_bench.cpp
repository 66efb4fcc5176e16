// A whole operation without a picture: a rod goes through the liver in two seconds.

#include "operation/run.h"

#include <benchmark/benchmark.h>

#include "support/bench_organs.h"
#include "support/rod.h"

using namespace resect;

namespace {

void runOperation(benchmark::State& state) {
  const Discretization cells = bench::liverCells(double(state.range(0)));
  const Aabb box = cells.lattice.box();
  const Vec3 start(box.min.x(), box.centre().y(), box.max.z()),
      end = start + Vec3(box.size().x(), 0, 0);
  Scenario scenario;
  scenario.duration = 2;
  scenario.tools = {
      {"",
       {},
       {},
       {{0, {start, Eigen::Quaterniond::Identity()}}, {2, {end, Eigen::Quaterniond::Identity()}}}}};
  double removed = 0;
  for (auto _ : state) {
    state.PauseTiming();
    Simulation simulation(makeOrgan(cells, {}), bench::rod());
    state.ResumeTiming();
    removed = double(runScenario(simulation, scenario).ledger.tissue().removed.particles);
  }
  state.counters["removed"] = removed;
}
BENCHMARK(runOperation)->Apply(bench::upToAMillion)->Unit(benchmark::kMillisecond);

// Where the instruments are in a frame, of a motion with a hundred keys.
void inputOfFrame(benchmark::State& state) {
  Scenario scenario;
  scenario.duration = 60;
  scenario.tools.resize(3);
  for (ScenarioTool& tool : scenario.tools)
    for (int key = 0; key < 100; ++key)
      tool.keys.push_back({0.6 * key, {Vec3(0.01 * key, 0.1, 0), Eigen::Quaterniond::Identity()}});
  std::int64_t frame = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(frameInput(scenario, frame++ % frameCount(scenario)).tools.size());
}
BENCHMARK(inputOfFrame);

}  // namespace
