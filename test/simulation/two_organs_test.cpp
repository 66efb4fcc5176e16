// Two organs of a scenario, held together by joints.
#include <doctest/doctest.h>

#include "io/data_folder.h"
#include "io/operation_setup.h"
#include "io/plain_mesh.h"
#include "io/scenario/scenario_file.h"

using namespace resect;

TEST_CASE("the hook lifts the gallbladder, and the liver under it follows") {
  Scenario scenario = readScenario(findDataFile("liver-and-gallbladder", "scenarios", ".toml"));
  Simulation simulation = makeSimulation(scenario, readPlainMesh);
  REQUIRE(simulation.organs().size() == 2);
  CHECK(simulation.joints().size() > 50);
  const auto points = [&](std::size_t organ) {
    const auto now = simulation.organs()[organ].points();
    return std::vector<Vec3f>(now.begin(), now.end());
  };
  std::vector<Vec3f> before[2];
  StepReport report;
  for (std::int64_t frame = 0; frame < 204; ++frame) {
    if (frame == 132)  // the hook is in, and has not pulled yet
      for (const std::size_t o : {0, 1}) before[o] = points(o);
    simulation.step(frameInput(scenario, frame), report);
    CHECK(report.faults.empty());
  }
  CHECK(simulation.organs()[0].tissue->gripped(1) == 0);
  CHECK(simulation.organs()[1].tissue->gripped(1) > 3);
  CHECK(report.toolForce[1].norm() > 1);
  for (const std::size_t o : {0, 1}) {
    const std::vector<Vec3f> now = points(o);
    REQUIRE(now.size() == before[o].size());
    float most = 0;
    for (std::size_t i = 0; i < now.size(); ++i)
      most = std::max(most, now[i].y() - before[o][i].y());
    CHECK(most > (o == 0 ? 0.004f : 0.01f));
  }
}
