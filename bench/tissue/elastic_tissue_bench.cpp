// A substep of elastic tissue, per particle: the fast kernels and the plain neighbour list, in one
// run. The bodies are the built-in liver at a number of particles, hanging from its upper cells.

#include <benchmark/benchmark.h>

#include "support/bench_organs.h"
#include "support/references/reference_tissue.h"
#include "tissue/elastic/elastic_tissue.h"

using namespace resect;

namespace {

TissueCells liver(double particles) {
  const Discretization cells = bench::liverCells(particles);
  return {cells.lattice, cells.inside, {liverTissue()}, {}};
}

double count(const TissueCells& cells) {
  double sum = 0;
  for (const std::uint8_t flag : cells.solid) sum += flag;
  return sum;
}

void report(benchmark::State& state, double particles, double substeps) {
  state.counters["particles"] = particles;
  state.counters["per particle and substep"] =
      benchmark::Counter(particles * substeps, benchmark::Counter::kIsIterationInvariantRate |
                                                   benchmark::Counter::kInvert);
}

void holdTop(ElasticTissue& tissue) {
  const Lattice& lattice = tissue.lattice();
  for (std::int64_t c = 0; c < lattice.cellCount(); ++c)
    if (tissue.solid(c) && lattice.cell(c).y() > 0.8 * lattice.dims.y()) tissue.hold(c, kHeldAll);
}

void substeps(benchmark::State& state, const char* kernel) {
  if (!kernelNamed(kernel)) {
    state.SkipWithError("not on this machine");
    return;
  }
  const TissueCells cells = liver(double(state.range(0)));
  ElasticTissue tissue(cells, {});
  tissue.useKernel(*kernelNamed(kernel));
  holdTop(tissue);
  constexpr int kSubsteps = 20;
  const double duration = 0.999 * kSubsteps * tissue.longestSubstep();
  for (auto _ : state) tissue.advance(duration);
  report(state, count(cells), kSubsteps);
}

void neighbourList(benchmark::State& state) {
  const TissueCells cells = liver(double(state.range(0)));
  test::ReferenceTissue<float> tissue(cells, 0.75);
  const ElasticTissue fast(cells, {});
  for (auto _ : state)
    tissue.step(float(fast.longestSubstep()), 0.2f, Eigen::Vector3f(0, -9.81f, 0));
  report(state, count(cells), 1);
}

// What a 60 Hz frame costs, with every thing that advance() does.
void frame(benchmark::State& state) {
  const TissueCells cells = liver(double(state.range(0)));
  ElasticTissue tissue(cells, {});
  holdTop(tissue);
  int n = 0;
  for (auto _ : state) n = tissue.advance(1.0 / 60).substeps;
  report(state, count(cells), n);
  state.counters["substeps"] = n;
  state.counters["bytes per particle"] = double(heldBytes(tissue)) / count(cells);
}

BENCHMARK_CAPTURE(substeps, avx512, "avx512")
    ->ArgName("particles")
    ->Arg(10'000)
    ->Arg(100'000)
    ->UseRealTime();
BENCHMARK_CAPTURE(substeps, avx2, "avx2")
    ->ArgName("particles")
    ->Arg(10'000)
    ->Arg(100'000)
    ->UseRealTime();
BENCHMARK_CAPTURE(substeps, baseline, "baseline")->ArgName("particles")->Arg(10'000)->UseRealTime();
BENCHMARK(neighbourList)->ArgName("particles")->Arg(10'000)->Arg(100'000)->UseRealTime();
BENCHMARK(frame)
    ->ArgName("particles")
    ->Arg(10'000)
    ->Arg(20'000)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
