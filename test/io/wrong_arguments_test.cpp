// Is an argument that cannot be right refused in one sentence, and nothing done?
#include <doctest/doctest.h>

#include <limits>

#include "io/mesh_file.h"
#include "io/operation_setup.h"
#include "io/plain_mesh.h"
#include "support/sentence.h"
#include "support/temporary_folder.h"

using namespace resect;
using test::refuses;

namespace {

// Is no simulation made of a scenario that differs from a right one by `change`?
template <typename Change>
bool simulationRefused(Change change, const char* what) {
  Scenario scenario;
  scenario.organs[0].source.spacing = 0.02;
  change(scenario);
  return refuses([&] { makeSimulation(scenario, readPlainMesh); }, what);
}

}  // namespace

TEST_CASE("no simulation is made of a scenario with values out of range") {
  const double none = std::numeric_limits<double>::quiet_NaN();
  CHECK(simulationRefused([](Scenario& s) { s.organs.clear(); }, "no organ"));
  for (const double wrong : {0.0, -0.02, none})
    CHECK(simulationRefused([&](Scenario& s) { s.organs[0].source.spacing = wrong; }, "spacing"));
  CHECK(
      simulationRefused([](Scenario& s) { s.organs[0].source.dims = Vec3i(0, 1, 1); }, "one cell"));
  CHECK(simulationRefused([](Scenario& s) { s.organs[0].source.settings.refine = 7; }, "refine"));
  CHECK(simulationRefused([&](Scenario& s) { s.frameRate = none; }, "frames a second"));
  CHECK(simulationRefused(
      [](Scenario& s) {
        s.joints.push_back({{"organ", "spleen"}});
      },
      "spleen"));
  CHECK(simulationRefused([](Scenario& s) { s.organs[0].source.file = "none.obj"; }, "none.ply"));
  CHECK(simulationRefused([](Scenario& s) { s.tools.resize(1); }, "tool"));
  CHECK(simulationRefused(
      [&](Scenario& s) {
        s.organs[0].tissue.elastic = true;
        s.organs[0].tissue.material.young = none;
      },
      "young"));
}

TEST_CASE("joints between organs that were not made are refused") {
  Scenario scenario;
  scenario.mode = OperationMode::Operation;
  scenario.joints.push_back({{"organ", "spleen"}});
  CHECK(refuses([&] { makeJoints(scenario, {}); }, "\"organ\""));
}

TEST_CASE("a surface with a point that is nowhere is not written") {
  const test::TemporaryFolder folder;
  for (const double wrong :
       {std::numeric_limits<double>::infinity(), 1e39, std::numeric_limits<double>::quiet_NaN()})
    for (const char* name : {"a.obj", "a.stl", "a.ply", "a.vtk", "a.iv"}) {
      const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, wrong, 0}}, {{0, 1, 2}}};
      CHECK(refuses([&] { writeMeshFile(folder / name, mesh); }, "which is nowhere"));
      CHECK_FALSE(std::filesystem::exists(folder / name));
    }
}
