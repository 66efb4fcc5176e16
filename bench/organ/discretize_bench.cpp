// A mesh of 80 000 triangles to a lattice with fractional values, and these fitted to the mesh.

#include <benchmark/benchmark.h>

#include "organ/fit_surface.h"
#include "support/bench_organs.h"

using namespace resect;

namespace {

void discretizeLiver(benchmark::State& state) {
  const double spacing = bench::spacingFor(double(state.range(0)));
  const Lattice lattice = latticeForSpacing(bounds(bench::liver()), spacing);
  for (auto _ : state) benchmark::DoNotOptimize(discretize(bench::liver(), lattice).value.size());
  state.counters["per particle"] =
      benchmark::Counter(double(state.range(0)), benchmark::Counter::kIsIterationInvariantRate |
                                                     benchmark::Counter::kInvert);
}
BENCHMARK(discretizeLiver)->Apply(bench::upToAMillion)->Unit(benchmark::kMillisecond);

void fitLiver(benchmark::State& state) {
  const Discretization shares = bench::liverCells(double(state.range(0)));
  for (auto _ : state) {
    state.PauseTiming();
    Discretization cells = shares;
    state.ResumeTiming();
    fitSurface(bench::liver(), cells);
    benchmark::DoNotOptimize(cells.skinScale);
  }
}
BENCHMARK(fitLiver)->Apply(bench::upToAMillion)->Unit(benchmark::kMillisecond);

}  // namespace
