#include "blood/bleeding.h"

#include <doctest/doctest.h>

#include "anatomy/small_vessels.h"
#include "base/random.h"
#include "organ/apply_edits.h"
#include "simulation/simulation.h"
#include "simulation/vein_block.h"
#include "support/block_organ.h"
#include "support/test_tools.h"

using namespace resect;
using test::cutAcrossVein;

namespace {

// A block of 60 x 30 x 60 mm of still tissue over the table, with these vessels, or a portal vein
// of 4 mm along x in its middle.
Simulation bleedingBlock(double height = 0, std::optional<Anatomy> vessels = {}) {
  Organ organ = makeOrgan(test::veinBlock(height), {});
  if (!vessels)
    vessels = test::straightVessel(VesselKind::PortalVein, Vec3(-0.02, height + 0.0151, 0.0301),
                                   Vec3(0.05, height + 0.0151, 0.0301), 0.002);
  organ.map = makeVesselMap(*vessels);
  return Simulation(std::move(organ), {});
}

FrameInput with(std::vector<TissueEdit> edits) {
  FrameInput input;
  input.edits = std::move(edits);
  return input;
}

void checkLedger(const StepReport& report) {
  REQUIRE(report.blood.ledger.bled == report.blood.ledger.found());
}

double ml(Picolitres volume) { return 1e6 * toCubicMetres(volume); }

}  // namespace

TEST_CASE("tissue whose vessel is cut bleeds, and every picolitre is found again in every frame") {
  Simulation simulation = bleedingBlock();
  StepReport report = simulation.step(with({cutAcrossVein()}));
  REQUIRE(report.vessels.size() == 1);
  double before = 0;
  for (int i = 0; i < 600; ++i) {
    report = simulation.step({});
    checkLedger(report);
    CHECK(ml(report.blood.ledger.bled) > before);
    before = ml(report.blood.ledger.bled);
  }
  REQUIRE(report.blood.ends.size() == 1);  // nothing feeds the sinusoids beyond the cut
  CHECK(report.blood.ends[0].end == VesselEnd::Root);
  CHECK(before >
        20);  // 4 mm of a portal vein: 11 ml/s, less what the block's one leaf lets through
  CHECK(report.blood.ledger.film > 0);
  CHECK(report.blood.ledger.pools > 0);  // it runs down the sides
  CHECK(report.blood.ledger.clotted > 0);
}

TEST_CASE("an organ without vessels does not bleed, and cut tissue of one with vessels oozes") {
  Organ plain = makeOrgan(test::fullBlock({6, 6, 6}), {});
  Simulation dry(std::move(plain), {});
  CHECK_FALSE(dry.blood().any());
  CHECK(dry.step(with({{0, -1, RemoveCell{3}}})).blood.ledger.bled == 0);

  Simulation simulation = bleedingBlock();
  const Lattice lattice = simulation.organ().rest.lattice;
  simulation.step(with({{0, -1, RemoveCell{lattice.index({6, 5, 1})}}}));  // far from the vein
  StepReport report;
  for (int i = 0; i < 60; ++i) report = simulation.step({});
  // Five faces were bared, 1.25 cm^2, each with 0.02 ml/s per cm^2.
  CHECK(ml(report.blood.ledger.bled) == doctest::Approx(0.02 * 1.25 * 61 / 60).epsilon(0.02));
}

TEST_CASE("a piece in which no vessel ends oozes no more once it is known to be cut off") {
  Simulation simulation = bleedingBlock();
  // Across z: the vein along x stays in the body, a third of the block is cut off.
  constexpr double z = 0.0401;
  const Vec3 before[] = {{-1, -1, z}, {-1, 1, z}}, after[] = {{1, -1, z}, {1, 1, z}};
  StepReport report = simulation.step(with({{0, -1, Incision{ruledBlade(before, after)}}}));
  const double both = report.blood.rate;
  for (int i = 0; i < 30; ++i) report = simulation.step({});
  checkLedger(report);
  CHECK(report.blood.rate == doctest::Approx(0.5 * both).epsilon(0.01));
}

TEST_CASE("clips on both sides of the cut stop the vessel, heat stops the rest") {
  // Beside it a hepatic vein, whose blood oozes when nothing comes from the portal vein.
  const auto along = [](VesselKind kind, const Vec3& from, const Vec3& to) {
    return VesselSegment{kind, -1, from, to, 0.002, true};
  };
  Simulation simulation = bleedingBlock(
      0,
      makeAnatomy(
          {along(VesselKind::PortalVein, Vec3(-0.02, 0.0151, 0.0301), Vec3(0.05, 0.0151, 0.0301)),
           along(VesselKind::HepaticVein, Vec3(0.055, 0.0151, -0.02), Vec3(0.055, 0.0151, 0.05))}));
  simulation.step(with({cutAcrossVein()}));
  const double share = (0.0321 + 0.02) / 0.07;
  StepReport report = simulation.step(
      with({{0, -1, PlaceClip{0, share - 0.05}}, {0, -1, PlaceClip{0, share + 0.05}}}));
  for (int i = 0; i < 5; ++i) report = simulation.step({});
  CHECK(report.blood.ends.empty());
  CHECK(report.blood.rate > 0);  // oozing
  const double oozes = report.blood.rate;
  for (int i = 0; i < 60; ++i)
    report = simulation.step(with({{0, -1, Heat{Vec3(0.032, 0.02, 0.03), 0.1, 50e3}}}));
  report = simulation.step({});
  CHECK(report.blood.rate < 1e-3 * oozes);
  checkLedger(report);
}

TEST_CASE("heat between forceps seals the ends of a vessel of 4 mm within seconds") {
  Simulation simulation = bleedingBlock();
  simulation.step(with({cutAcrossVein()}));
  StepReport report = simulation.step({});
  REQUIRE(report.blood.ends.size() == 1);
  int frames = 0;
  for (; frames < 600 && !report.blood.ends.empty(); ++frames)
    report = simulation.step(with({{0, -1, Heat{Vec3(0.0321, 0.0151, 0.0301), 0.004, 30}}}));
  CHECK(frames > 60);
  CHECK(frames < 300);
  CHECK(simulation.organ().vessels.injuries[0].sealed == 3);
  for (int i = 0; i < 60; ++i) report = simulation.step({});
  CHECK(report.blood.ends.empty());
}

TEST_CASE("a swab holds a vein back while it presses harder than the vein, and soaks up blood") {
  Simulation simulation = bleedingBlock();
  StepReport report = simulation.step(with({cutAcrossVein()}));
  for (int i = 0; i < 60; ++i) report = simulation.step({});
  const double rate = report.blood.rate;
  const Vec3 end = report.blood.ends[0].place;
  const auto pressed = [&](double pressure) {
    for (int i = 0; i < 60; ++i)
      report = simulation.step(with({{0, -1, Press{end, 0.02, pressure, 4e-6}}}));
    return report.blood.rate;
  };
  // The block's one vein carries all blood of the bowel: pressed, its pressure rises towards 12
  // kPa.
  CHECK(pressed(3000) == doctest::Approx((1 - 3.0 / 12) * rate).epsilon(0.1));
  pressed(13000);
  CHECK(report.blood.rate < 0.25 * rate);
  CHECK(report.blood.ends.empty());
  CHECK(report.blood.ends.empty());
  CHECK(report.blood.ledger.absorbed > 0);
  CHECK(report.blood.ledger.absorbed <= toPicolitres(8.1e-6));
  for (int i = 0; i < 60; ++i) report = simulation.step({});
  CHECK(report.blood.rate == doctest::Approx(rate).epsilon(0.1));
  checkLedger(report);
}

TEST_CASE("suction takes the blood within its reach, and clamping the inflow slows the bleeding") {
  Simulation simulation = bleedingBlock();
  StepReport report = simulation.step(with({cutAcrossVein()}));
  for (int i = 0; i < 240; ++i) report = simulation.step({});
  const double rate = report.blood.rate;
  CHECK(report.blood.ledger.sucked == 0);
  for (int i = 0; i < 60; ++i)
    report = simulation.step(with({{0, -1, Suction{Vec3(0.03, 0.03, 0.03), 0.08, 50e-6}}}));
  checkLedger(report);
  CHECK(ml(report.blood.ledger.sucked) > 1);
  simulation.step(with({{0, -1, ClampInflow{true}}}));
  for (int i = 0; i < 30; ++i) report = simulation.step({});
  CHECK(report.blood.rate < 0.3 * rate);
}

TEST_CASE("blood under an overhang drips, and falls past a table that is not there") {
  Discretization cells = test::veinBlock();
  cells.lattice.origin.y() = 0.2;
  Organ organ = makeOrgan(std::move(cells), {});
  organ.map = makeVesselMap(test::straightVessel(
      VesselKind::PortalVein, Vec3(-0.02, 0.2126, 0.0301), Vec3(0.05, 0.2126, 0.0301), 0.002));
  Simulation simulation(std::move(organ), {}, nullptr, false);
  simulation.step(with({{0, -1, Incision{test::acrossX(0.0321, 0.1, 0.3)}}}));
  bool dripped = false;
  StepReport report;
  for (int i = 0; i < 900; ++i) {
    report = simulation.step({});
    checkLedger(report);
    dripped |= report.blood.ledger.drops > 0;
  }
  CHECK(dripped);
  CHECK(report.blood.ledger.lost > 0);
  CHECK(report.blood.ledger.pools == 0);
}

TEST_CASE("the ledger stays exact through random cuts, removals, tears, suction, clips and heat") {
  Simulation simulation = bleedingBlock();
  const Lattice lattice = simulation.organ().rest.lattice;
  Random random(5);
  StepReport report;
  for (int frame = 0; frame < 1200; ++frame) {
    std::vector<TissueEdit> edits;
    const auto place = [&] {
      return Vec3(random.uniform(0, 0.06), random.uniform(0, 0.03), random.uniform(0, 0.06));
    };
    switch (random.below(12)) {
      case 0:
        edits.push_back({0, -1, RemoveCell{random.below(int(lattice.cellCount()))}});
        break;
      case 1: {
        const double x = random.uniform(0.005, 0.045);
        edits.push_back({0, -1, Incision{test::acrossX(x, random.uniform(0, 0.02), 0.05)}});
        break;
      }
      case 2:
        edits.push_back(
            {0, -1, SeverBond{random.below(int(lattice.cellCount())), random.below(26)}});
        break;
      case 3:
        edits.push_back({0, -1, Suction{place(), 0.015, 25e-6}});
        break;
      case 4:
        edits.push_back({0, -1, Heat{place(), 0.004, 3000}});
        break;
      case 6:
        edits.push_back({0, -1, Press{place(), 0.015, 2000, 4e-6}});
        break;
      case 7:
        if (frame > 500) edits.push_back({0, -1, DivideVessel{0, random.uniform()}});
        break;
      case 5:
        if (frame > 800) edits.push_back({0, -1, PlaceClip{0, random.uniform()}});
        break;
      default:
        break;
    }
    report = simulation.step(with(std::move(edits)));
    checkLedger(report);
  }
  CHECK(ml(report.blood.ledger.bled) > 5);
}

TEST_CASE("nobody loses more blood than he has") {
  Organ organ = makeOrgan(test::fullBlock({12, 6, 12}), {});
  const Vec3 middle = organ.rest.lattice.box().centre();
  organ.map = makeVesselMap(test::straightVessel(VesselKind::PortalVein, middle - Vec3(0.05, 0, 0),
                                                 middle + Vec3(0.02, 0, 0), 0.002));
  std::vector<OperatedOrgan> organs;
  organs.push_back(operatedOrgan("block", std::move(organ)));
  Circulation small;
  small.volume = 20e-6;
  Bleeding bleeding(organs, small);
  std::vector<TissueEdit> edits{
      {0, -1, Incision{test::acrossX(middle.x(), middle.y() - 0.01, middle.y() + 0.05)}}};
  std::vector<std::int64_t> removed;
  applyEdits(organs[0], 0, edits, removed);
  BloodReport report;
  double fastest = 0;
  for (int i = 0; i < 3600; ++i) {
    bleeding.step(organs, edits, 1.0 / 60, (i + 1) / 60.0, false, report);
    fastest = std::max(fastest, report.rate);
    edits.clear();
  }
  CHECK(ml(report.ledger.bled) > 15);
  CHECK(ml(report.ledger.bled) <= 20);
  CHECK(report.rate < 0.02 * fastest);
  CHECK(report.ledger.bled == report.ledger.found());
}

TEST_CASE("a saved operation bleeds on with the same bits") {
  Simulation one = bleedingBlock(), other = bleedingBlock();
  one.step(with({cutAcrossVein()}));
  for (int i = 0; i < 100; ++i) one.step({});
  other.restore(one.save());
  for (int i = 0; i < 100; ++i) {
    one.step({});
    other.step({});
  }
  CHECK(one.stateHash() == other.stateHash());
}

TEST_CASE("the grade of bleeding follows its rate in millilitres a minute") {
  const auto grade = [](double mlPerMinute) { return bleedingGrade(mlPerMinute / 60e6); };
  CHECK(grade(0) == 0);
  CHECK(grade(1) == 0);
  CHECK(grade(4) == 1);
  CHECK(grade(9) == 2);
  CHECK(grade(49) == 3);
  CHECK(grade(51) == 4);
}
