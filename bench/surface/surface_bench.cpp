// The surface from nothing, and after a bite of 200 particles out of organs of growing size.

#include <benchmark/benchmark.h>

#include "support/bench_organs.h"
#include "surface/surface_tracker.h"

using namespace resect;

namespace {

// Counter that shows the time per item.
benchmark::Counter timePer(double items) {
  return {items, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert};
}

void buildSurface(benchmark::State& state) {
  const ColourField field(bench::liverCells(double(state.range(0))), int(state.range(1)));
  double triangles = 0;
  for (auto _ : state) {
    const SurfaceTracker surface(field, 50);
    triangles = double(surface.triangleCount());
  }
  state.counters["triangles"] = triangles;
  state.counters["per triangle"] = timePer(triangles);
}

void updateAfterBite(benchmark::State& state) {
  const Discretization cells = bench::liverCells(double(state.range(0)));
  const std::vector<std::int64_t> bite = bench::bite(cells, 200);
  ColourField field(cells, 2);
  SurfaceTracker surface(field, 50);
  bool removed = false;
  for (auto _ : state) {
    removed = !removed;
    for (const std::int64_t cell : bite) field.setCellValue(cell, removed ? 0 : cells.value[cell]);
    surface.update(field, field.update());
  }
  const double bricks = double(surface.changes().bricks);
  state.counters["bricks"] = bricks;
  state.counters["per brick"] = timePer(bricks);
}

void sizes(benchmark::internal::Benchmark* b) {
  b->ArgName("particles")->Arg(1'000)->Arg(10'000)->Arg(100'000)->Arg(1'000'000)->UseRealTime();
}
BENCHMARK(buildSurface)->Apply(bench::upToAMillionOfNodes)->Unit(benchmark::kMillisecond);
BENCHMARK(updateAfterBite)->Apply(sizes)->Unit(benchmark::kMicrosecond);

}  // namespace
