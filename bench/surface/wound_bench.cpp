// Incisions: a blade that advances through the liver, and what a cell of the wound costs.

#include <benchmark/benchmark.h>

#include <cmath>

#include "organ/organ.h"
#include "support/bench_organs.h"

using namespace resect;

namespace {

// The built-in liver in cells of 5 mm and a blade held upright in it, its edge `depth` under the
// top; drawn along +X.
struct Operation {
  Organ organ;
  Vec3 top;

  Operation()
      : organ(makeOrgan(
            discretize(bench::liver(), latticeForSpacing(bounds(bench::liver()), 0.005)), {})) {
    const Aabb box = organ.rest.lattice.box();
    top = box.centre();
    top.y() = box.min.y();
    for (const Vec3& p : organ.surface.mesh().points)
      if ((p - top).head<1>().norm() < 0.004 && std::abs(p.z() - top.z()) < 0.004)
        top.y() = std::max(top.y(), p.y());
  }
  std::vector<Vec3> edge(double x, double depth) const { return bench::uprightEdge(top, x, depth); }
};

// One advance of 5 mm: grid edges severed, bricks meshed. The argument is the depth in mm.
void advanceBlade(benchmark::State& state) {
  const Operation fresh;
  const double depth = 1e-3 * double(state.range(0));
  Operation operation = fresh;
  double x = -0.04, edges = 0, bricks = 0, steps = 0;
  for (auto _ : state) {
    if (x > 0.035) {
      state.PauseTiming();
      operation = fresh;
      x = -0.04;
      state.ResumeTiming();
    }
    edges += double(incise(operation.organ,
                           ruledBlade(operation.edge(x, depth), operation.edge(x + 0.005, depth))));
    updateSurface(operation.organ, updateField(operation.organ));
    bricks += double(operation.organ.surface.changes().bricks);
    x += 0.005;
    ++steps;
  }
  state.counters["edges"] = edges / steps;
  state.counters["bricks"] = bricks / steps;
}

// The bricks of a finished wound, drawn again.
void drawWound(benchmark::State& state) {
  Operation operation;
  Organ& organ = operation.organ;
  incise(organ, ruledBlade(operation.edge(-0.05, 0.03), operation.edge(0.05, 0.03)));
  updateSurface(organ, updateField(organ));
  std::vector<std::int64_t> bricks;
  for (std::int64_t b = 0; b < organ.field.brickCount(); ++b)
    if (organ.severed.near(b) && organ.field.slot(b) != ColourField::kEmpty) bricks.push_back(b);
  double cells = 0;
  for (auto _ : state) {
    cells = 0;
    for (const std::int64_t b : bricks) {
      BrickSigns signs;
      BrickWound wound;
      makeBrickWound(organ.field, {organ.severed, organ.alive}, organ.field.brick(b), signs, 50,
                     wound);
      cells += std::popcount(wound.cells);
    }
  }
  state.counters["cut cells"] = cells;
  state.counters["bricks"] = double(bricks.size());
  state.counters["per cell"] = {
      cells, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert};
}

BENCHMARK(advanceBlade)->Apply(bench::atDepths);
BENCHMARK(drawWound)->Unit(benchmark::kMicrosecond);

}  // namespace
