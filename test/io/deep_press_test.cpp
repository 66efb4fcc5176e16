// A tip that is narrower than a cell is pressed deep into the built-in liver. The scenario's hand
// comes aslant, and the skin there is sloped.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "io/data_folder.h"
#include "io/operation_setup.h"
#include "io/plain_mesh.h"
#include "io/scenario/scenario_file.h"

using namespace resect;

namespace {

constexpr int kPressed = 182;  // frame: the tip was pressed in by 35 mm and then stood for 0.5 s

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

Pressed press(double spacing, bool capsule) {
  Scenario scenario = readScenario(findDataFile("press", "scenarios", ".toml"));
  scenario.organs[0].source.spacing = spacing;
  Simulation simulation = makeSimulation(scenario, readPlainMesh);
  if (!capsule) {  // pressed to the same place
    scenario.tools[2].way.reset();
    scenario.organs[0].tissue.material.capsule = 0;
    simulation = makeSimulation(scenario, readPlainMesh);
  }
  StepReport report;
  const std::size_t baton = 2;
  double most = 0;
  for (int frame = 0; frame <= kPressed; ++frame) {
    simulation.step(frameInput(scenario, frame), report);
    most = std::max(most, report.toolForce[baton].norm());
  }
  const Pose pose = simulation.tools()[baton].way.to.pose;
  const Vec3 axis = Vec3(0, 0.95, 0.3).normalized();  // the scenario's handle
  return {report.toolForce[baton].norm(), most,
          lastCrossing(simulation.surfaceMesh(), pose.position, axis)};
}

}  // namespace

TEST_CASE("a narrow tip that is pressed deep into the liver dents the skin") {
  const Pressed coarse = press(0.008, true), fine = press(0.005, true);
  for (const Pressed& p : {coarse, fine}) {
    MESSAGE(p.force << " N, " << 1e3 * p.inside << " mm inside");
    CHECK(p.force > 2.5);
    CHECK(p.inside < 0.01);  // of 35 mm
  }
  CHECK(coarse.force == doctest::Approx(fine.force).epsilon(0.15));
}

TEST_CASE("the liver's capsule resists a deep press") {
  const Pressed with = press(0.008, true), without = press(0.008, false);
  MESSAGE(with.most << " N, without a capsule " << without.most << " N");
  CHECK(with.most > 1.05 * without.most);
}
