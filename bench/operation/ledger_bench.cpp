// What the ledger costs, with cuts and without: it is reckoned once a second of simulated time.

#include "operation/ledger/ledger.h"

#include <benchmark/benchmark.h>

#include "organ/cell_labels.h"
#include "support/bench_organs.h"
#include "support/cuts.h"
#include "tissue/elastic/elastic_tissue.h"

using namespace resect;

namespace {

// cut: whether three planes go through the whole liver and a slab is taken out of it.
void ledgerOf(benchmark::State& state, bool elastic, bool cut) {
  Discretization cells = bench::liverCells(double(state.range(0)));
  std::unique_ptr<TissueModel> tissue;
  if (elastic)
    tissue = std::make_unique<ElasticTissue>(
        TissueCells{cells.lattice, cells.inside, {liverTissue()}, {}}, TissueSettings{});
  Region ball;
  ball.shape = Region::Shape::Ball;
  ball.centre = cells.lattice.box().centre();
  ball.radius = 0.02;
  markCells(cells, 1, ball);
  labelSkin(cells);
  cells.nameLabel(1, "tumour");
  Simulation simulation(makeOrgan(std::move(cells), {}), {}, std::move(tissue));
  const Lattice& lattice = simulation.organ().rest.lattice;
  const Vec3 middle = lattice.box().centre();
  if (cut) {
    for (const Vec3& normal : {Vec3(1, 0.1, 0.2), Vec3(0.9, 0.3, 0), Vec3(0.2, 0.1, 1)})
      test::cutAlong(simulation, {normal.normalized(), normal.normalized().dot(middle) + 0.03});
    FrameInput input;
    for (std::int64_t c = 0; c < lattice.cellCount(); ++c)
      if (std::abs(lattice.centre(lattice.cell(c)).x() - middle.x() + 0.04) < 0.005)
        input.edits.push_back({0, -1, RemoveCell{c}});
    simulation.step(input);
  }
  const LedgerBooks books(std::vector<TissueSetup>(1), simulation);
  Ledger ledger;
  for (auto _ : state) ledger = books.ledgerOf(simulation);
  state.counters["particles"] = double(ledger.tissue().before.particles);
  state.counters["cut_cm2"] = 1e4 * ledger.organs[0].cut;
  state.counters["bared_cm2"] = 1e4 * ledger.organs[0].bared;
}
BENCHMARK_CAPTURE(ledgerOf, still, false, false)
    ->Arg(13000)
    ->Arg(989140)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ledgerOf, still_cut, false, true)
    ->Arg(13000)
    ->Arg(989140)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ledgerOf, elastic, true, false)->Arg(13000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ledgerOf, elastic_cut, true, true)->Arg(13000)->Unit(benchmark::kMillisecond);

}  // namespace
