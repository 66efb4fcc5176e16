// The colour field from nothing, with one and two nodes a cell: all bricks that can hold the
// surface.

#include <benchmark/benchmark.h>

#include "sph/colour_field.h"
#include "support/bench_organs.h"

using namespace resect;

namespace {

void buildField(benchmark::State& state) {
  const Discretization cells = bench::liverCells(double(state.range(0)));
  double nodes = 0;
  for (auto _ : state) {
    const ColourField field(cells, int(state.range(1)));
    nodes = double(field.slotCount()) * kBrickSize;
    benchmark::DoNotOptimize(field.values(0).data());
  }
  state.counters["stored nodes"] = nodes;
  state.counters["per node"] = benchmark::Counter(
      nodes, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(buildField)->Apply(bench::upToAMillionOfNodes)->Unit(benchmark::kMillisecond);

}  // namespace
