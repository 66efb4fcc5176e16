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

void buildBoth(benchmark::State& state) {
  const Discretization cells = bench::liverCells(double(state.range(0)));
  double triangles = 0;
  for (auto _ : state)
    triangles =
        double(buildFieldAndSurface(cells, int(state.range(1)), 50).surface.triangleCount());
  const auto [field, surface] = buildFieldAndSurface(cells, int(state.range(1)), 50);
  double withSurface = 0;
  for (const std::int32_t b : field.builtBricks()) {
    const Vec3 first = (kBrickNodes * field.brick(b)).cast<double>();
    const Vec3 middle = field.nodePosition(first + Vec3::Constant(kBrickNodes / 2));
    bool any = false;
    surface.visitTriangles(field, {middle, middle}, [&](const Triangle&) { any = true; });
    withSurface += any;
  }
  state.counters["bricks"] = double(field.builtBricks().size());
  state.counters["with surface"] = withSurface;
  state.counters["triangles"] = triangles;
  state.counters["per triangle"] = timePer(triangles);
}

// Normals and shares of cut, for a picture of it.
void buildLook(benchmark::State& state) {
  const ColourField field(bench::liverCells(double(state.range(0))), int(state.range(1)));
  SurfaceTracker surface(field, 50);
  for (auto _ : state) {
    state.PauseTiming();
    surface.setIso(field, 50);
    state.ResumeTiming();
    surface.updateLook(field);
  }
  state.counters["triangles"] = double(surface.triangleCount());
  state.counters["per triangle"] = timePer(double(surface.triangleCount()));
}

void updateAfterBite(benchmark::State& state) {
  const Discretization cells = bench::liverCells(double(state.range(0)));
  const std::vector<std::int64_t> bite = bench::bite(cells, 200);
  ColourField field(cells, 2);
  SurfaceTracker surface(field, 50);
  const bool look = state.range(1) != 0;
  if (look) surface.updateLook(field);
  bool removed = false;
  for (auto _ : state) {
    removed = !removed;
    for (const std::int64_t cell : bite) field.setCellValue(cell, removed ? 0 : cells.value[cell]);
    surface.update(field, field.update());
    if (look) surface.updateLook(field);
  }
  const double bricks = double(surface.changes().bricks);
  state.counters["bricks"] = bricks;
  state.counters["per brick"] = timePer(bricks);
}

void sizes(benchmark::internal::Benchmark* b) {
  b->ArgNames({"particles", "look"})->ArgsProduct({{1'000, 10'000, 100'000, 1'000'000}, {0, 1}});
  b->UseRealTime();
}
BENCHMARK(buildSurface)->Apply(bench::upToAMillionOfNodes)->Unit(benchmark::kMillisecond);
BENCHMARK(buildBoth)->Apply(bench::upToAMillionOfNodes)->Unit(benchmark::kMillisecond);
BENCHMARK(buildLook)->Apply(bench::upToAMillionOfNodes)->Unit(benchmark::kMillisecond);
BENCHMARK(updateAfterBite)->Apply(sizes)->Unit(benchmark::kMicrosecond);

}  // namespace
