// A tip that is narrower than a cell is pressed deep into the built-in liver. The scenario's hand
// comes aslant, and the skin there is sloped.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/data_folder.h"
#include "io/operation_setup.h"
#include "io/plain_mesh.h"
#include "io/scenario/scenario_file.h"
#include "support/figures.h"

using namespace resect;

namespace {

// Frame of the scenario in which the tip has been pressed in by some 11 mm. Far deeper, the liver
// without a capsule, which lies flatter, resists as much: it is pressed against the table.
constexpr int kPressed = 130;

struct Pressed {
  double force;   // N, in that frame
  double most;    // N
  double inside;  // m: from where the tool's axis enters tissue to the tip; 0 if it does not
};

// Along the ray from `from` (direction unit): distance to the last crossing of the surface.
double lastCrossing(const TriangleMesh& mesh, const Vec3& from, const Vec3& direction) {
  double last = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.points[std::size_t(t[0])];
    Mat3 m;
    m << mesh.points[std::size_t(t[1])] - a, mesh.points[std::size_t(t[2])] - a, -direction;
    if (std::abs(m.determinant()) < 1e-18) continue;
    const Vec3 x = m.inverse() * (from - a);
    if (x.x() >= 0 && x.y() >= 0 && x.x() + x.y() <= 1) last = std::max(last, x.z());
  }
  return last;
}

// The state in frame `last` of the scenario, in which tool 2, the baton, presses.
Pressed pressed(Simulation& simulation, const Scenario& scenario, int last) {
  StepReport report;
  const std::size_t baton = 2;
  double most = 0;
  for (int frame = 0; frame <= last; ++frame) {
    simulation.step(frameInput(scenario, frame), report);
    most = std::max(most, report.toolForce[baton].norm());
  }
  const Pose pose = simulation.tools()[baton].way.to.pose;
  const Vec3 axis = Vec3(0, 0.95, 0.3).normalized();  // the scenario's handle
  return {report.toolForce[baton].norm(), most,
          lastCrossing(simulation.surfaceMesh(), pose.position, axis)};
}

// Pressed in by 25 mm at a place, in fractions as in OrganWay, and held for 0.45 s.
Pressed pressAt(double spacing, double x, double z) {
  Scenario scenario = readScenario(findDataFile("press", "scenarios", ".toml"));
  scenario.organs[0].source.spacing = spacing;
  std::vector<WayKey>& keys = scenario.tools[2].way->keys;
  keys.resize(3);
  for (WayKey& key : keys) {
    key.place.x() = x;
    key.place.z() = z;
    key.share = false;
    key.depth = 0.025;
  }
  keys[0].time = 0.1;
  keys[0].depth = -0.04;
  keys[1].speed = 0.1;
  Simulation simulation = makeSimulation(scenario, readPlainMesh);
  return pressed(simulation, scenario, 72);
}

// As the scenario presses.
Pressed press(bool capsule) {
  Scenario scenario = readScenario(findDataFile("press", "scenarios", ".toml"));
  Simulation simulation = makeSimulation(scenario, readPlainMesh);
  if (!capsule) {  // pressed to the same place
    scenario.tools[2].way.reset();
    scenario.organs[0].tissue.material.capsule = 0;
    simulation = makeSimulation(scenario, readPlainMesh);
  }
  return pressed(simulation, scenario, kPressed);
}

}  // namespace

TEST_CASE("a narrow tip that is pressed deep into the liver dents the skin, wherever it presses") {
  test::Figures figures("deep press");
  for (const auto& [x, z] : {std::pair(0.25, 0.5), {0.35, 0.5}, {0.3888, 0.6264}, {0.55, 0.4}}) {
    const Pressed coarse = pressAt(0.008, x, z), fine = pressAt(0.005, x, z);
    MESSAGE("at " << x << ", " << z << ": cells of 8 mm " << coarse.force << " N, "
                  << 1e3 * coarse.inside << " mm inside; of 5 mm " << fine.force << " N, "
                  << 1e3 * fine.inside << " mm inside");
    CHECK(coarse.inside < 0.008);  // of 25 mm
    CHECK(fine.inside < 0.003);
    CHECK(figures.add(fmt::format("force at ({:g}, {:g}), cells of 8 mm against 5 mm (N)", x, z),
                      coarse.force, fine.force, 0.15) < 0.15);
  }
}

TEST_CASE("the liver's capsule resists a tip that is pressed in") {
  const Pressed with = press(true), without = press(false);
  MESSAGE(with.most << " N, without a capsule " << without.most << " N");
  CHECK(with.most > 1.1 * without.most);
}
