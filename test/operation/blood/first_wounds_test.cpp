#include "operation/first_wounds.h"

#include <doctest/doctest.h>

#include "anatomy/small_vessels.h"
#include "base/error.h"
#include "support/block_organ.h"
#include "tissue/still_tissue.h"

using namespace resect;

namespace {

// A block of 60 x 30 x 60 mm, moved and not aligned to its box, with an artery along x.
OperatedOrgan block() {
  Discretization cells = test::fullBlock({12, 6, 12});
  cells.lattice.origin = Vec3(0.1037, 0.0521, -0.0213);
  const Vec3 corner = cells.lattice.box().min;
  Organ organ = makeOrgan(std::move(cells), {});
  organ.map = makeVesselMap(test::straightVessel(VesselKind::HepaticArtery,
                                                 corner + Vec3(0.002, 0.0151, 0.0301),
                                                 corner + Vec3(0.05, 0.0151, 0.0301), 0.001));
  auto tissue = std::make_unique<StillTissue>(organ.rest.lattice, organ.alive);
  return operatedOrgan("block", std::move(organ), std::move(tissue));
}

double bledIn(const OrganWound& wound, int frames) {
  std::vector<OperatedOrgan> organs;
  organs.push_back(block());
  makeWounds({&wound, 1}, organs[0]);
  Simulation simulation(std::move(organs), {});
  StepReport report;
  for (int i = 0; i < frames; ++i) report = simulation.step({});
  CHECK(report.blood.ledger.bled == report.blood.ledger.found());
  return 1e6 * toCubicMetres(report.blood.ledger.bled);
}

}  // namespace

TEST_CASE("an organ with a wound bleeds from the vessel in it, from the first frame on") {
  // Across the artery, in the middle of the block: in fractions of its box, and in metres.
  OrganWound wound{Vec3(0.5, 1.0, 0.3), Vec3(0.5, 1.0, 0.7), false, -Vec3::UnitY(), 0.025};
  const double bled = bledIn(wound, 1);
  CHECK(bled > 0);
  CHECK(bledIn(wound, 60) > 1);  // an artery of 2 mm: 10 ml/s where nothing lies beyond
  const Aabb box = block().organ.rest.lattice.box();
  wound.inWorld = true;
  wound.from = box.min + Vec3(0.5, 1.0, 0.3).cwiseProduct(box.max - box.min);
  wound.to = box.min + Vec3(0.5, 1.0, 0.7).cwiseProduct(box.max - box.min);
  CHECK(bledIn(wound, 1) == bled);
  wound.depth = 0.008;  // it ends above the artery
  CHECK(bledIn(wound, 60) == 0);
}

TEST_CASE("a wound that meets no tissue is refused with the place of the organ") {
  OperatedOrgan organ = block();
  const OrganWound wound{Vec3(0.5, 1.5, 0.3), Vec3(0.5, 1.5, 0.7), false, -Vec3::UnitY(), 0.005};
  CHECK_THROWS_WITH_AS(
      makeWounds({&wound, 1}, organ),
      doctest::Contains("wound 1 of organ \"block\" cuts no tissue; move it, or make it deeper"),
      Error);
}
