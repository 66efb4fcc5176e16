// A whole frame: a rod that takes away what it touches, or touches nothing, in tissue at rest.

#include <benchmark/benchmark.h>

#include <memory>

#include "simulation/simulation.h"
#include "support/bench_organs.h"
#include "support/rod.h"

using namespace resect;

namespace {

FrameInput at(const Vec3& place) {
  FrameInput input;
  input.tools = {{{place, Eigen::Quaterniond::Identity()}}};
  return input;
}

// 2 mm a frame, through the liver from one side to the other; then another liver.
void cutFrame(benchmark::State& state) {
  const Discretization cells = bench::liverCells(double(state.range(0)));
  const Aabb box = cells.lattice.box();
  const Vec3 start(box.min.x(), box.centre().y(), box.max.z());
  const int frames = int(box.size().x() / 0.002);
  std::unique_ptr<Simulation> simulation;
  StepReport report;
  double removed = 0;
  int frame = frames;
  for (auto _ : state) {
    if (frame == frames) {
      state.PauseTiming();
      simulation = std::make_unique<Simulation>(makeOrgan(cells, {}), bench::rod());
      simulation->step(at(start), report);
      frame = 0;
      state.ResumeTiming();
    }
    simulation->step(at(start + Vec3(0.002 * ++frame, 0, 0)), report);
    removed += double(report.removed);
  }
  state.counters["removed"] = benchmark::Counter(removed, benchmark::Counter::kAvgIterations);
}
BENCHMARK(cutFrame)->Apply(bench::upToAMillion)->Unit(benchmark::kMicrosecond);

// Half a metre above the organ.
void idleFrame(benchmark::State& state) {
  Simulation simulation(makeOrgan(bench::liverCells(double(state.range(0))), {}), bench::rod());
  StepReport report;
  int frame = 0;
  for (auto _ : state) simulation.step(at({0.002 * (++frame % 100), 0.5, 0}), report);
}
BENCHMARK(idleFrame)->Apply(bench::upToAMillion)->Unit(benchmark::kMicrosecond);

}  // namespace
