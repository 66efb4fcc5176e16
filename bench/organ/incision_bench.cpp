// A blade that advances through a liver that has sagged under its weight: what one advance costs in
// tissue that moves. The blade is that of the tissue at rest (tissue/cutting_edge.h).

#include <benchmark/benchmark.h>

#include "organ/incision/strands.h"
#include "support/bench_organs.h"
#include "tissue/cut_bonds.h"
#include "tissue/elastic/elastic_tissue.h"
#include "tissue/move_tissues.h"

using namespace resect;

namespace {

// The built-in liver in cells of 5 mm after half a second on the table, and a blade held upright in
// it, its edge `depth` under the top; drawn along +X.
struct Operation {
  Organ organ;
  ElasticTissue tissue;
  Vec3 top;

  static Discretization cells() {
    TriangleMesh mesh = bench::liver();
    const double lowest = bounds(mesh).min.y();
    for (Vec3& p : mesh.points) p.y() -= lowest;
    return discretize(mesh, latticeForSpacing(bounds(mesh), 0.005));
  }
  Operation()
      : organ(makeOrgan(cells(), {})),
        tissue({organ.rest.lattice, organ.alive, {liverTissue()}, {}}, {}) {
    TissueStep step;
    const Obstacle table = tableTop();
    for (int frame = 0; frame < 30; ++frame) moveTissue(tissue, {&table, 1}, 1.0 / 60, step);
    top = organ.rest.lattice.box().centre();
    top.y() = 0;
    for (std::int64_t c = 0; c < organ.rest.lattice.cellCount(); ++c) {
      if (!tissue.solid(c)) continue;
      const Vec3 x = place(c);
      if (std::abs(x.x() - top.x()) < 0.004 && std::abs(x.z() - top.z()) < 0.004)
        top.y() = std::max(top.y(), x.y() + 0.0025);
    }
  }
  Vec3 place(std::int64_t cell) const {
    return organ.rest.lattice.centre(organ.rest.lattice.cell(cell)) + tissue.displacement(cell);
  }
  std::vector<Vec3> edge(double x, double depth) const { return bench::uprightEdge(top, x, depth); }
};

// One advance of 5 mm: an incision as the tissue hands it on, and the bricks meshed. The argument
// is the depth in mm.
void advanceBlade(benchmark::State& state) {
  static const Operation fresh;
  const double depth = 1e-3 * double(state.range(0));
  Operation operation = fresh;
  double x = -0.04, edges = 0, bonds = 0, steps = 0;
  for (auto _ : state) {
    state.PauseTiming();
    if (x > 0.035) {
      operation = fresh;
      x = -0.04;
    }
    const SweptBlade blade = ruledBlade(operation.edge(x, depth), operation.edge(x + 0.005, depth));
    const Lattice& lattice = operation.organ.rest.lattice;
    std::vector<std::int64_t> near;
    visitCellsIn(lattice, blade.bounds.padded(2 * lattice.spacing.x()), [&](const Vec3i& at) {
      const std::int64_t cell = lattice.index(at);
      if (operation.organ.alive[std::size_t(cell)]) near.push_back(cell);
    });
    state.ResumeTiming();
    edges += double(incise(operation.organ, blade, CutsBetweenCells::One));
    const std::vector<TissueBond> crossed = crossedBonds(operation.tissue, lattice, blade);
    for (const TissueBond& bond : crossed) operation.tissue.sever(bond.cell, bond.direction);
    partStrands(operation.organ, operation.tissue, crossed, near);
    updateSurface(operation.organ, updateField(operation.organ));
    bonds += double(crossed.size());
    x += 0.005;
    ++steps;
  }
  state.counters["edges"] = edges / steps;
  state.counters["bonds"] = bonds / steps;
}

BENCHMARK(advanceBlade)->Apply(bench::atDepths);

}  // namespace
