// Elastic tissue under long random work.
//
// Instruments work on a liver at random: pressed, dragged, hooked, cut, snipped, driven through and
// taken elsewhere at once. RESECT_WORK_SECONDS: how long, in simulated seconds (8);
// RESECT_WORK_SEED.
#include <doctest/doctest.h>

#include <cstdlib>

#include "base/random.h"
#include "geometry/measures.h"
#include "geometry/topology.h"
#include "organ/discretize.h"
#include "organ/tissue_cells.h"
#include "simulation/random_hands.h"
#include "simulation/simulation.h"
#include "support/environment.h"
#include "tissue/elastic/elastic_tissue.h"

using namespace resect;

TEST_CASE("random work on a liver: all numbers finite, faults mended, no energy from nowhere") {
  const double seconds = test::numberFrom("RESECT_WORK_SECONDS", 8);
  Random random(std::uint64_t(test::numberFrom("RESECT_WORK_SEED", 1)));
  const TriangleMesh mesh = test::lyingLiver().mesh;
  Discretization cells = discretize(mesh, latticeForSpacing(bounds(mesh), 0.008));
  const std::int64_t particles = cells.particleCount();
  auto owned = std::make_unique<ElasticTissue>(tissueCells(cells, liverTissue()), TissueSettings{});
  ElasticTissue& tissue = *owned;
  Simulation simulation(makeOrgan(std::move(cells), {}), test::instruments(), std::move(owned));
  test::RandomHands hands(random, int(simulation.tools().size()), bounds(mesh));

  const double start = tissue.energy().total();
  double before = start, work = 0, worked = 0, lost = 0, excess = 0;  // J
  std::int64_t severed = 0, torn = 0, retries = 0, faults = 0;
  int faultsInARow = 0;
  for (std::int64_t frame = 0; double(frame) / 60 < seconds; ++frame) {
    const FrameInput input = hands.next(simulation.time(), frame > 30);  // it has come to lie
    const StepReport report = simulation.step(input);
    severed += report.severed;
    torn += report.torn;
    retries += report.tissue[0].retries;
    const bool fault = !report.faults.empty();
    faults += fault;
    faultsInARow = fault ? faultsInARow + 1 : 0;
    REQUIRE(faultsInARow < 30);
    const double energy = tissue.energy().total();
    REQUIRE(std::isfinite(energy));
    if (frame > 30) {
      // What an instrument does that is there at once counts as its work.
      const double done = hands.jumps()
                              ? std::max(energy - before, 0.0)
                              : -report.toolForce[std::size_t(hands.tool())].dot(hands.moved());
      work += done;
      worked += std::abs(done);
    }
    before = energy;
    // What is lost to damping, friction and cuts never comes back.
    lost = std::max(lost, start + work - energy);
    excess = std::max(excess, lost - (start + work - energy));
    if (frame % 60 != 59) continue;
    for (const Vec3f& p : simulation.surfacePoints()) REQUIRE(p.allFinite());
    const Topology shape = topology(simulation.surfaceMesh());
    REQUIRE(shape.closed());
    REQUIRE(shape.oriented());
    REQUIRE(simulation.organ().particles == particles);
  }
  MESSAGE(hands.acts() << " acts in " << seconds << " s: " << severed << " bonds cut, " << torn
                       << " torn, " << retries << " frames begun again, " << faults
                       << " faults; work " << work << " J, lost " << lost << " J, of which "
                       << excess << " J came back");
  CHECK(hands.acts() > 1);
  CHECK(excess < 0.01 * worked);
}
