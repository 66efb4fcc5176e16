// A patient who breathes: how the liver in the operative field follows, and that the state is kept.
#include <doctest/doctest.h>

#include <numbers>

#include "base/parallel.h"
#include "geometry/rotation.h"
#include "io/data_folder.h"
#include "io/operation_setup.h"
#include "io/plain_mesh.h"
#include "io/scenario/scenario_file.h"
#include "organ/region_placer.h"
#include "support/sentence.h"

using namespace resect;

namespace {

Scenario fieldLiver(double depth, double spacing = 0.012) {
  Scenario scenario = readScenario(findDataFile("incise", "scenarios", ".toml"));
  setSpacing(scenario, *scenario.organs[0].source.spacing, spacing);
  setBreathing(scenario, depth);
  return scenario;
}

// All tools lie in the tray.
FrameInput idle(const Scenario& scenario) {
  FrameInput input;
  for (const ScenarioTool& tool : scenario.tools) input.tools.push_back({tool.rest, false, 1});
  return input;
}

// Mean displacement of the upper and of the lower fifth of the organ, m.
struct Means {
  Vec3 dome = Vec3::Zero(), ground = Vec3::Zero();
};
Means meansOf(const Simulation& simulation) {
  const Lattice& lattice = simulation.organ().rest.lattice;
  const Aabb box = particleBox(simulation.organ().rest);
  Means means;
  int high = 0, low = 0;
  for (std::int64_t c = 0; c < lattice.cellCount(); ++c) {
    if (!simulation.tissue().solid(c)) continue;
    const double height =
        (lattice.centre(lattice.cell(c)).y() - box.min.y()) / (box.max.y() - box.min.y());
    if (height > 0.8) means.dome += simulation.tissue().displacement(c), ++high;
    if (height < 0.2) means.ground += simulation.tissue().displacement(c), ++low;
  }
  means.dome /= high, means.ground /= low;
  return means;
}

// How far breathing moves parts of the liver of `incise`, at most, m.
struct Follows {
  double dome = 0, ground = 0, aside = 0;
};
Follows followed(double bed, double degrees) {
  Scenario scenario = fieldLiver(0.01);
  scenario.breathing.bed = bed;
  scenario.organs[0].source.pose.rotation =
      rotationAbout(Vec3::UnitY(), degrees * std::numbers::pi / 180);
  Scenario stillScenario = scenario;
  stillScenario.breathing.depth = 0;
  Simulation simulation = makeSimulation(scenario, readPlainMesh),
             still = makeSimulation(stillScenario, readPlainMesh);
  const FrameInput input = idle(scenario);
  StepReport report;
  Follows most;
  for (int i = 0; i < 900; ++i) {
    simulation.step(input, report);
    CHECK(report.faults.empty());
    still.step(input);
    if (i < 300) continue;  // it settles first
    const Means now = meansOf(simulation), rest = meansOf(still);
    most.dome = std::max(most.dome, (now.dome - rest.dome).z());
    most.ground = std::max(most.ground, (now.ground - rest.ground).z());
    most.aside = std::max(most.aside, std::abs((now.dome - rest.dome).x()));
  }
  MESSAGE("of 10 mm: dome ", 1e3 * most.dome, " mm, ground ", 1e3 * most.ground, " mm, aside ",
          1e3 * most.aside);
  return most;
}

}  // namespace

TEST_CASE("the liver in the field follows the diaphragm, however it lies in its lattice") {
  for (const double degrees : {0.0, 30.0}) {
    CAPTURE(degrees);
    const Follows most = followed(0.8, degrees);
    CHECK(most.dome > 0.0075);
    CHECK(most.dome < 0.0105);
    CHECK(most.ground > 0.007);
    CHECK(most.aside < 0.001);
  }
  // On a bed that stays still, friction holds the liver against its ligament.
  CHECK(followed(0, 0).ground < 0.002);
}

TEST_CASE("a patient without breathing has the same state as before there was breathing") {
  Scenario scenario = fieldLiver(0), deep = fieldLiver(0.01);
  Simulation simulation = makeSimulation(scenario, readPlainMesh),
             breathing = makeSimulation(deep, readPlainMesh);
  bool named = false;
  for (const StateColumn& column : simulation.fields().root.fields)
    named |= column.name == "breath";
  CHECK(!named);
  FrameInput input = idle(scenario);
  simulation.step(input);
  input.breathes = true;  // there is nothing to begin
  simulation.step(input);
  CHECK(simulation.breathing().depth == 0);
  CHECK(test::sentenceOf([&] { simulation.restore(breathing.save()); }) != "");
}

TEST_CASE("an operation restored in the middle of a breath goes on with the same bits") {
  Scenario scenario = fieldLiver(0.015);
  Simulation simulation = makeSimulation(scenario, readPlainMesh),
             other = makeSimulation(scenario, readPlainMesh);
  const auto inputAt = [&](int frame) {
    FrameInput input = frameInput(scenario, frame);
    if (frame == 130) input.breathes = false;
    return input;
  };
  for (int i = 0; i < 100; ++i) simulation.step(inputAt(i));
  CHECK(simulation.breath().phase > 0.1);
  const Bytes saved = simulation.save();
  for (int i = 100; i < 160; ++i) simulation.step(inputAt(i));
  for (const int threads : {1, 2, 3}) {
    const ThreadLimit limit(threads);
    other.restore(saved);
    CHECK(other.breath().on);
    for (int i = 100; i < 160; ++i) other.step(inputAt(i));
    CHECK(firstDifference(simulation.fields(), other.fields()).value_or("") == "");
    CHECK(simulation.stateHash() == other.stateHash());
  }
  CHECK(!simulation.breath().on);
}

TEST_CASE("a minute of breathing under a scalpel that rests on the liver stays calm") {
  Scenario scenario = fieldLiver(0.01, 0.015);
  Simulation simulation = makeSimulation(scenario, readPlainMesh);
  // Settles first; then the scalpel stands 12 mm deep in the top of the liver.
  FrameInput input = idle(scenario);
  for (int i = 0; i < 90; ++i) simulation.step(input);
  Vec3 top(0, -1, 0);
  for (const Vec3f& p : simulation.surfacePoints())
    if (p.y() > top.y()) top = p.cast<double>();
  REQUIRE(scenario.tools[0].model.find("scalpel") != std::string::npos);
  input.tools[0] = {{top - Vec3(0, 0.012, 0), rotationAbout(Vec3::UnitX(), -1.2)}, true, 0};
  StepReport report;
  double strongest = 0;
  std::int64_t cut = 0;
  for (int i = 0; i < 3600; ++i) {
    simulation.step(input, report);
    REQUIRE(report.faults.empty());
    REQUIRE(report.tissue[0].calm);
    REQUIRE(report.tissue[0].retries == 0);
    REQUIRE(report.toolForce[0].allFinite());
    cut += report.severed;
    strongest = std::max(strongest, report.toolForce[0].norm());
  }
  MESSAGE("strongest force ", strongest, " N, ", cut, " bonds cut");
  CHECK(strongest > 0.01);
  CHECK(strongest < 5);
  const Means means = meansOf(simulation);
  CHECK(means.dome.allFinite());
  CHECK(means.dome.norm() < 0.03);
}

TEST_CASE("breathing that is none is refused") {
  Scenario scenario = fieldLiver(0);
  Simulation simulation = makeSimulation(scenario, readPlainMesh);
  for (const Breathing wrong : {Breathing{-0.01, 12, 1, true}, Breathing{NAN, 12, 1, true},
                                Breathing{0.01, 0, 1, true}, Breathing{0.01, 12, 2, true}})
    CHECK(test::refuses([&] { simulation.setBreathing(wrong); }, "breathing is"));
}
