// The walls of wide vessels pull: inside the tissue, and where they run bare.
#include "organ/vessel_cords.h"

#include <doctest/doctest.h>

#include "anatomy/small_vessels.h"
#include "geometry/rotation.h"
#include "simulation/simulation.h"
#include "support/block_organ.h"
#include "tissue/elastic/elastic_tissue.h"

using namespace resect;

namespace {

constexpr double kBarSide = 0.006;              // m
const Vec3i kBarDims(5, 14, 5);                 // a bar that hangs
constexpr int kGrooveLow = 6, kGrooveHigh = 7;  // layers that are taken away
constexpr double kRadius = 0.002;               // m, of the vessel

// A bar that hangs from its top, with a vein along it that leans by `tilt`, rad; tilt < 0: none.
Simulation bar(double tilt) {
  Discretization cells = test::fullBlock(kBarDims, kBarSide);
  cells.lattice.origin = Vec3(0.013, 0.5, -0.02);
  const Aabb box = cells.lattice.box();
  TissueSettings settings;
  settings.drag = 4;
  auto tissue = std::make_unique<ElasticTissue>(
      TissueCells{cells.lattice, cells.inside, {TissueMaterial()}, {}}, settings);
  TissueAttachment top;
  top.box = {Vec3(box.min.x() - 1, box.max.y() - 1.5 * kBarSide, box.min.z() - 1),
             Vec3::Constant(1) + box.max};
  tissue->attach(top);
  tissue->settle();
  Organ organ = makeOrgan(std::move(cells), {});
  if (tilt >= 0) {
    const Vec3 half = 0.5 * box.size().y() * (rotationAbout(Vec3::UnitZ(), tilt) * Vec3::UnitY());
    organ.map = makeVesselMap(test::straightVessel(VesselKind::PortalVein, box.centre() + half,
                                                   box.centre() - half, kRadius));
  }
  return Simulation(std::move(organ), {}, std::move(tissue), false);
}

// Removes the groove; vessels of 1 mm stay.
FrameInput removeGroove(const Simulation& simulation) {
  FrameInput input;
  const Lattice& lattice = simulation.organ().rest.lattice;
  for (std::int64_t cell = 0; cell < lattice.cellCount(); ++cell)
    if (const int y = lattice.cell(cell).y(); y >= kGrooveLow && y <= kGrooveHigh)
      input.edits.push_back({0, -1, RemoveCell{cell, 0.001}});
  return input;
}

// How far the middle of the lowest layer has sunk, m.
double sunk(const Simulation& simulation) {
  const Lattice& lattice = simulation.organ().rest.lattice;
  const std::int64_t cell = lattice.index({kBarDims.x() / 2, 0, kBarDims.z() / 2});
  return -simulation.organs()[0].tissue->displacement(cell).y();
}

void run(Simulation& simulation, double seconds) {
  for (int i = 0; i < int(60 * seconds); ++i) simulation.step({});
}

}  // namespace

TEST_CASE("a bare vein holds what hangs on it, until it is divided") {
  for (const double tilt : {0.0, 0.12}) {
    CAPTURE(tilt);
    Simulation simulation = bar(tilt);
    run(simulation, 1);
    const double before = sunk(simulation);
    simulation.step(removeGroove(simulation));
    CHECK(simulation.organ().vessels.bared.size() == 1);
    CHECK(simulation.organ().vessels.injuries.empty());
    run(simulation, 3);
    const double held = sunk(simulation);
    CHECK(held > before);
    CHECK(held < 0.02);
    run(simulation, 0.5);
    CHECK(sunk(simulation) == doctest::Approx(held).epsilon(0.02));  // at rest

    FrameInput divide;
    divide.edits.push_back({0, -1, DivideVessel{0, 0.5}});
    simulation.step(divide);
    run(simulation, 0.5);
    CHECK(sunk(simulation) > 0.3);  // falls
  }
  Simulation without = bar(-1);
  without.step(removeGroove(without));
  run(without, 0.5);
  CHECK(sunk(without) > 0.3);
}

// The bar has E A = 5 kPa x 9 cm^2 = 4.5 N, the vein's wall 0.62 MPa x 5.5 mm^2 = 3.4 N.
TEST_CASE("a wide vein stiffens the tissue along its way, and not across it") {
  Simulation plain = bar(-1), with = bar(0);
  run(plain, 3), run(with, 3);
  const double share = sunk(with) / sunk(plain);
  CAPTURE(share);
  CHECK(share < 0.8);
  CHECK(share > 0.4);
  Simulation across = bar(1.5708);  // 84 mm long, but all of it outside is no cord
  run(across, 3);
  CHECK(sunk(across) / sunk(plain) > 0.97);
}

TEST_CASE("cords are those of wide and of bare vessels, and none leads over a cut") {
  Simulation simulation = bar(0);
  const auto cords = [&] {
    return vesselCords(simulation.organ(), *simulation.organs()[0].tissue);
  };
  CHECK(cords().size() == std::size_t(kBarDims.y() - 1));
  simulation.step(removeGroove(simulation));
  CHECK(cords().size() == std::size_t(kBarDims.y() - 1 - (kGrooveHigh - kGrooveLow + 1)));
  FrameInput cut;
  cut.edits.push_back({0, -1, DivideVessel{0, 0.2}});
  simulation.step(cut);
  CHECK(cords().size() == std::size_t(kBarDims.y() - 2 - (kGrooveHigh - kGrooveLow + 1)));
  for (const VesselCord& one : cords()) CHECK(one.cord.stiffness > 0);
}

TEST_CASE("an operation that was saved with a bare vein goes on as it would have") {
  Simulation simulation = bar(0.12), other = bar(0.12);
  simulation.step(removeGroove(simulation));
  // Heat makes tissue stiffer, and so the substeps shorter and the cords' limits higher.
  const Lattice& lattice = simulation.organ().rest.lattice;
  FrameInput heat;
  heat.edits.push_back({0, -1, Heat{lattice.centre({2, 10, 2}), 0.008, 400}});
  for (int i = 0; i < 120; ++i) simulation.step(heat);
  CHECK(!simulation.organ().fields.coagulated.empty());
  run(simulation, 0.5);
  other.restore(simulation.save());
  run(simulation, 0.5), run(other, 0.5);
  CHECK(simulation.stateHash() == other.stateHash());
}
