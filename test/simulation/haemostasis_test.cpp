// Instruments that stop bleeding or avoid it, on a block of still tissue with one vein.
#include <doctest/doctest.h>

#include "anatomy/small_vessels.h"
#include "simulation/simulation.h"
#include "simulation/vein_block.h"
#include "support/test_tools.h"

using namespace resect;
using test::cutAcrossVein;

namespace {

constexpr double kHeight = 0.0151, kDepth = 0.0301;

// The vein runs along x.
Simulation blockWith(std::vector<std::unique_ptr<Tool>> tools, double radius = 0.002) {
  Organ organ = makeOrgan(test::veinBlock(), {});
  organ.map = makeVesselMap(test::straightVessel(
      VesselKind::PortalVein, Vec3(-0.02, kHeight, kDepth), Vec3(0.05, kHeight, kDepth), radius));
  return Simulation(std::move(organ), std::move(tools));
}

template <typename... Tools>
std::vector<std::unique_ptr<Tool>> list(Tools... tools) {
  std::vector<std::unique_ptr<Tool>> all;
  (all.push_back(std::move(tools)), ...);
  return all;
}

// A small instrument with its tip at the origin and its handle upwards.
std::unique_ptr<Tool> instrument(const char* kind, bool jaws = false) {
  return test::describedTool(kind, boxMesh({{-0.001, -0.001, 0}, {0.001, 0.001, 0.06}}),
                             [&](ToolModel& m) {
                               if (!jaws) return;
                               m.jaws.pivot = Vec3(0, 0, 0.03);
                               m.jaws.opening = 0.4;
                             });
}

const Eigen::Quaterniond kUpright(Eigen::AngleAxisd(-1.5707963267948966, Vec3::UnitX()));

ToolInput uprightAt(const Vec3& place, double squeeze = 0) {
  return {{place, kUpright}, true, squeeze};
}
ToolInput away() { return {{Vec3(1, 1, 1), kUpright}, false}; }

StepReport stepWith(Simulation& simulation, std::vector<ToolInput> tools,
                    std::vector<TissueEdit> edits = {}) {
  FrameInput input;
  input.tools = std::move(tools);
  input.edits = std::move(edits);
  return simulation.step(input);
}

// Draws the aspirator down to the vein and along z through the block, at x.
void drawGroove(Simulation& simulation, std::size_t tool, double x) {
  std::vector<ToolInput> inputs(simulation.tools().size(), away());
  for (double y = 0.029; y > 0.006; y -= 0.003)
    for (double z = 0.0; z < 0.061; z += 0.002) {
      inputs[tool] = uprightAt({x, y, z});
      stepWith(simulation, inputs);
    }
}

}  // namespace

TEST_CASE(
    "an aspirator leaves a vein of 4 mm bare, which then is clipped and divided without loss") {
  auto scissors = test::describedTool(
      "scissors", boxMesh({{-0.001, -0.001, 0}, {0.001, 0.001, 0.08}}), [](ToolModel& m) {
        m.edge = {{0, 0, 0}, {0, 0, 0.025}};
        m.jaws.pivot = Vec3(0, 0, 0.03);
        m.jaws.opening = 0.6;
      });
  Simulation simulation = blockWith(
      list(instrument("aspirator"), instrument("clip_applier", true), std::move(scissors)));
  drawGroove(simulation, 0, 0.0175);
  drawGroove(simulation, 0, 0.0225);
  const Organ& organ = simulation.organ();
  CHECK(organ.removed > 50);
  CHECK(organ.vessels.injuries.empty());
  REQUIRE(organ.vessels.bared == std::vector<std::int32_t>{0});

  // Clips on both sides, close to the groove's walls; each press sets one.
  for (const double x : {0.0165, 0.0235}) {
    const Vec3 place(x, kHeight, kDepth);
    for (const double squeeze : {0.0, 0.5, 1.0, 1.0})
      stepWith(simulation, {away(), uprightAt(place, squeeze), away()});
    stepWith(simulation, {away(), away(), away()});
  }
  REQUIRE(organ.vessels.clips.size() == 2);
  CHECK(organ.vessels.clips[0].share < (0.02 + 0.02) / 0.07);
  CHECK(organ.vessels.clips[1].share > (0.02 + 0.02) / 0.07);

  // The scissors close across it, from above.
  const Vec3 tip(0.02, kHeight - 0.008, kDepth);
  for (double squeeze = 0; squeeze < 1.01; squeeze += 0.1)
    stepWith(simulation, {away(), away(), uprightAt(tip, std::min(squeeze, 1.0))});
  REQUIRE(organ.vessels.injuries.size() == 1);
  CHECK(organ.vessels.injuries[0].severed());
  StepReport report;
  for (int i = 0; i < 60; ++i) report = stepWith(simulation, {away(), away(), away()});
  CHECK(report.blood.ends.empty());
}

TEST_CASE("an aspirator takes thin vessels with the tissue") {
  Simulation simulation = blockWith(list(instrument("aspirator")), 0.0004);
  drawGroove(simulation, 0, 0.0225);
  CHECK(simulation.organ().vessels.bared.empty());
  REQUIRE(simulation.organ().vessels.injuries.size() == 1);
  CHECK(simulation.organ().vessels.injuries[0].severed());
}

TEST_CASE("a clip goes to a bleeding end within its reach") {
  Simulation simulation = blockWith(list(instrument("clip_applier", true)));
  StepReport report = stepWith(simulation, {away()}, {cutAcrossVein()});
  for (int i = 0; i < 5; ++i) report = stepWith(simulation, {away()});
  REQUIRE(report.blood.ends.size() == 1);
  const Vec3 near = Vec3(0.0321, kHeight, kDepth) + Vec3(0.003, 0.002, -0.003);
  for (const double squeeze : {0.0, 0.5, 1.0, 1.0, 0.5, 0.0})
    report = stepWith(simulation, {uprightAt(near, squeeze)});
  const VesselState& vessels = simulation.organ().vessels;
  REQUIRE(vessels.clips.size() == 1);
  CHECK(vessels.clipped(vessels.injuries[0], VesselEnd::Root));
  report = stepWith(simulation, {away()});
  CHECK(report.blood.ends.empty());
}

TEST_CASE("clips and forceps take the bleeding end at their tips, not a larger one beside it") {
  // An artery of 1.4 mm, and 7 mm beside it a vein of 6 mm that bleeds more.
  const auto both = [](std::unique_ptr<Tool> tool) {
    Organ organ = makeOrgan(test::veinBlock(), {});
    const auto along = [](VesselKind kind, double z, double radius) {
      return VesselSegment{kind, -1, Vec3(-0.02, kHeight, z), Vec3(0.05, kHeight, z), radius, true};
    };
    organ.map = makeVesselMap(makeAnatomy({along(VesselKind::PortalVein, kDepth + 0.007, 0.003),
                                           along(VesselKind::HepaticArtery, kDepth, 0.0007)}));
    return Simulation(std::move(organ), list(std::move(tool)));
  };
  const Vec3 artery(0.0321, kHeight, kDepth);
  for (const char* kind : {"clip_applier", "bipolar"}) {
    CAPTURE(kind);
    Simulation simulation = both(instrument(kind, true));
    StepReport report = stepWith(simulation, {away()}, {cutAcrossVein()});
    for (int i = 0; i < 10; ++i) report = stepWith(simulation, {away()});
    REQUIRE(report.blood.ends.size() == 2);
    CHECK(report.blood.ends[0].flow > 2 * report.blood.ends[1].flow);
    stepWith(simulation, {uprightAt(artery + Vec3(0, 0.001, -0.002), 0)});
    for (int i = 0; i < 150; ++i)
      report = stepWith(simulation, {uprightAt(artery + Vec3(0, 0.001, -0.002), 1)});
    REQUIRE(report.blood.ends.size() == 1);
    CHECK(report.blood.ends[0].segment == 0);  // the vein
  }
}

TEST_CASE("a vein that bleeds elsewhere can be clipped where it is whole") {
  Simulation simulation = blockWith(list(instrument("clip_applier", true)));
  stepWith(simulation, {away()}, {cutAcrossVein()});
  const Vec3 place(0.006, kHeight, kDepth);  // 26 mm from the cut
  for (const double squeeze : {0.0, 0.5, 1.0}) stepWith(simulation, {uprightAt(place, squeeze)});
  const VesselState& vessels = simulation.organ().vessels;
  REQUIRE(vessels.clips.size() == 1);
  CHECK(vessels.clips[0].share == doctest::Approx((0.006 + 0.02) / 0.07).epsilon(0.02));
}

TEST_CASE("a clip takes the bare vein between its jaws, not an artery that bleeds beside them") {
  Organ organ = makeOrgan(test::veinBlock(), {});
  const auto along = [](VesselKind kind, double z, double radius) {
    return VesselSegment{kind, -1, Vec3(-0.02, kHeight, z), Vec3(0.05, kHeight, z), radius, true};
  };
  organ.map =
      makeVesselMap(makeAnatomy({along(VesselKind::PortalVein, kDepth, 0.002),
                                 along(VesselKind::HepaticArtery, kDepth + 0.006, 0.0007)}));
  Simulation simulation(std::move(organ),
                        list(instrument("aspirator"), instrument("clip_applier", true)));
  drawGroove(simulation, 0, 0.0175);
  drawGroove(simulation, 0, 0.0225);
  const Vec3 vein(0.0205, kHeight, kDepth), artery(0.0205, kHeight, kDepth + 0.006);
  stepWith(simulation, {away(), away()}, {{0, -1, DivideVessel{1, 0.58}}});
  StepReport report;
  for (int i = 0; i < 10; ++i) report = stepWith(simulation, {away(), away()});
  REQUIRE_FALSE(report.blood.ends.empty());
  for (const BleedingEnd& end : report.blood.ends) CHECK(end.segment == 1);
  for (const double squeeze : {0.0, 0.5, 1.0, 0.0})
    stepWith(simulation, {away(), uprightAt(vein, squeeze)});
  const VesselState& vessels = simulation.organ().vessels;
  REQUIRE(vessels.clips.size() == 1);
  CHECK(vessels.clips[0].segment == 0);
  for (const double squeeze : {0.5, 1.0})
    stepWith(simulation, {away(), uprightAt(artery, squeeze)});
  REQUIRE(vessels.clips.size() == 2);
  CHECK(vessels.clips[1].segment == 1);
}

TEST_CASE("bipolar forceps seal a cut vein while their tips are closed, and only then") {
  Simulation simulation = blockWith(list(instrument("bipolar", true)));
  StepReport report = stepWith(simulation, {away()}, {cutAcrossVein()});
  const Vec3 place(0.0321, kHeight, kDepth);
  for (int i = 0; i < 120; ++i) report = stepWith(simulation, {uprightAt(place, 0.5)});
  CHECK(simulation.organ().heat.empty());
  REQUIRE(report.blood.ends.size() == 1);
  for (int i = 0; i < 300; ++i) report = stepWith(simulation, {uprightAt(place, 1)});
  CHECK(report.blood.ends.empty());
  CHECK(simulation.organ().vessels.injuries[0].sealed == 3);
  CHECK(simulation.organ().heat.coagulated(place) > 0.9);
}

TEST_CASE("a clamp shuts the inflow at the hilum, until it is opened or closed there again") {
  Simulation simulation = blockWith(list(instrument("inflow_clamp", true)));
  const Vec3 hilum(-0.01, kHeight, kDepth), elsewhere(0.05, 0.2, kDepth);
  const auto squeeze = [&](const Vec3& place, std::initializer_list<double> squeezes) {
    for (const double s : squeezes) stepWith(simulation, {uprightAt(place, s)});
    return simulation.organ().vessels.inflowClamped;
  };
  CHECK_FALSE(squeeze(elsewhere, {0, 0.6, 1}));
  CHECK_FALSE(squeeze(hilum, {0, 0}));
  CHECK(squeeze(hilum, {0, 0.6, 1, 1, 1}));
  CHECK(simulation.organ().vessels.clampedTime == doctest::Approx(3.0 / 60));
  CHECK(squeeze(elsewhere, {1, 0.3}));
  CHECK_FALSE(squeeze(hilum, {0.3, 1}));  // a hand that had let go takes it off
  CHECK(squeeze(hilum, {0, 1}));
  CHECK_FALSE(squeeze(hilum, {1, 0.4}));
}

TEST_CASE("a swab slows a cut vein under it while it is pressed, and takes up blood") {
  Simulation simulation = blockWith(list(instrument("gauze")));
  StepReport report = stepWith(simulation, {away()}, {cutAcrossVein()});
  for (int i = 0; i < 60; ++i) report = stepWith(simulation, {away()});
  const double before = report.blood.rate;
  for (int i = 0; i < 60; ++i) report = stepWith(simulation, {uprightAt({0.0321, 0.031, kDepth})});
  CHECK(report.blood.rate < before);
  CHECK(report.blood.ledger.absorbed > 0);
  const Picolitres absorbed = report.blood.ledger.absorbed;
  for (int i = 0; i < 60; ++i) report = stepWith(simulation, {away()});
  CHECK(report.blood.ledger.absorbed == absorbed);
  CHECK(report.blood.ledger.bled == report.blood.ledger.found());
}

TEST_CASE("a pencil coagulates where it cuts") {
  auto pencil = test::describedTool(
      "pencil", boxMesh({{-0.0003, -0.002, 0}, {0.0003, 0.002, 0.06}}), [](ToolModel& m) {
        m.edge = {{0, -0.002, 0}, {0, -0.002, 0.02}};
      });
  Simulation simulation = blockWith(list(std::move(pencil)));
  for (double z = 0.005; z < 0.05; z += 0.0001)
    stepWith(simulation, {uprightAt({0.0321, 0.022, z})});
  CHECK(simulation.organ().severed.count() > 0);
  CHECK(simulation.organ().heat.coagulated(Vec3(0.0321, 0.0235, 0.03)) > 0.5);
  CHECK(simulation.organ().heat.coagulated(Vec3(0.045, 0.0235, 0.03)) == 0);
}

TEST_CASE("with its pedal pressed a pencil coagulates the surface and cuts nothing") {
  auto pencil = test::describedTool(
      "pencil", boxMesh({{-0.0003, -0.002, 0}, {0.0003, 0.002, 0.06}}), [](ToolModel& m) {
        m.edge = {{0, -0.002, 0}, {0, -0.002, 0.02}};
      });
  Simulation simulation = blockWith(list(std::move(pencil)));
  for (double z = 0.02; z < 0.04; z += 0.0001) {
    ToolInput input = uprightAt({0.0321, 0.029, z});
    input.pedal = 1;
    stepWith(simulation, {input});
  }
  CHECK(simulation.organ().severed.count() == 0);
  CHECK(simulation.organ().removed == 0);
  CHECK(simulation.organ().heat.coagulated(Vec3(0.0321, 0.028, 0.03)) > 0.5);
  CHECK(simulation.organ().heat.coagulated(Vec3(0.0321, 0.015, 0.03)) == 0);
}
