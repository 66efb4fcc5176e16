#include "io/operation_setup.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "geometry/measures.h"
#include "geometry/primitives.h"
#include "io/scenario/scenario_file.h"
#include "operation/room.h"
#include "organ/builtin/builtin_gallbladder.h"
#include "organ/builtin/builtin_liver.h"
#include "support/sentence.h"

using namespace resect;

TEST_CASE("built-in organs are read from files that equal what their formulas give, bit for bit") {
  const auto noFile = [](const std::filesystem::path&, const std::string&) -> Model {
    FAIL("no other file is read");
    return {};
  };
  OrganSource source;
  source.onTable = false;
  const auto equals = [&](const TriangleMesh& formula) {
    const TriangleMesh mesh = loadOrganMesh(source, noFile, nullptr);
    CHECK(mesh.points == formula.points);
    CHECK(mesh.triangles == formula.triangles);
  };
  equals(builtinLiver());
  source.file = "gallbladder";
  equals(builtinGallbladder());
}

namespace {

// Points of a soft gallbladder's skin that lie deeper than 3 mm in the tray's walls, after it fell
// on their rim.
int pointsInWalls(const std::string& room) {
  Scenario scenario = parseScenario(
      "title = \"Fall\"\nduration = 0.6\nframe_rate = 60\n" + room +
          "[organ]\nsource = \"gallbladder\"\nspacing = \"8mm\"\nsettle = false\nposition = [0.27, "
          "0.06, 0.12]\n[tissue]\nmodel = \"elastic\"\ndrag = 6\n",
      "test.toml");
  Simulation simulation = makeSimulation(scenario, {});
  StepReport report;
  for (std::int64_t frame = 0; frame < frameCount(scenario); ++frame)
    simulation.step(frameInput(scenario, frame), report);
  const Aabb outer = bounds(toolBoxWalls()).padded(-0.003);
  const Aabb hollow{{-0.138 - 0.003, -1, -0.098 - 0.003}, {0.138 + 0.003, 1, 0.098 + 0.003}};
  int inside = 0;
  for (const Vec3& point : simulation.surfaceMesh().points) {
    const Vec3 p = toolBoxPose().inverse() * point;
    inside += outer.contains(p) && !hollow.contains(p);
  }
  return inside;
}

}  // namespace

TEST_CASE("tissue that falls on the rim of the tray does not go into its walls") {
  CHECK(pointsInWalls("[room]\ntool_box = false\n") > 20);
  CHECK(pointsInWalls("") == 0);
}

TEST_CASE("frames that will take seconds, and older keys, are told of before the first one") {
  const auto notes = [](const std::string& tissue) {
    std::vector<std::string> all;
    Scenario scenario =
        parseScenario(fmt::format("title = \"Stiff\"\nduration = 1\nframe_rate = "
                                  "1\n[organ]\nspacing = \"9mm\"\n[tissue]\nmodel = "
                                  "\"elastic\"\nthreads = 1\n{}",
                                  tissue),
                      "test.toml");
    makeSimulation(scenario, {}, {}, &all);
    return all;
  };
  CHECK(notes("").empty());
  CHECK(notes("tear_energy = 100\n").empty());
  const auto older = notes("tear_stretch = 1.46\nstiffening = 0\n");
  REQUIRE(older.size() == 1);
  CHECK_MESSAGE(older[0].starts_with("tear_stretch = 1.46 is read as tear_energy = 4.2"), older[0]);
  CHECK_THROWS_WITH_AS(notes("tear_stretch = 2\ntear_energy = 100\n"),
                       doctest::Contains("keep one of the two"), Error);
  CHECK_THROWS_AS(notes("tear_energy = 0\n"), Error);
  const auto stiff = notes("young = 1e9\npoisson = 0.49\n");
  REQUIRE(stiff.size() == 1);
  CHECK_MESSAGE(stiff[0].starts_with("each frame will take about"), stiff[0]);
  CHECK(stiff[0].find("softer tissue (young, poisson)") != stiff[0].npos);
}

namespace {

// A hollow ball of radius 4 cm, as a reader would read it.
ModelReader hollowBall(double wall) {
  TriangleMesh mesh = sphereMesh({0, 0, 0}, 0.04, 24),
               inner = sphereMesh({0, 0, 0}, 0.04 - wall, 24);
  flip(inner);
  append(mesh, inner);
  return [mesh](const std::filesystem::path& path, const std::string&) {
    return Model{path.string(), "OBJ", {{"", mesh}}};
  };
}

std::vector<std::string> notesOf(double wall, double spacing) {
  OrganSource source;
  source.file = "bladder.obj";
  source.spacing = spacing;
  std::vector<std::string> notes;
  loadCells(source, hollowBall(wall), {}, &notes);
  return notes;
}

}  // namespace

TEST_CASE("walls that are too thin for the cells are told with the spacing that would do") {
  const auto toldLast = [](const std::vector<std::string>& notes) { return notes.back(); };
  CHECK(test::refuses([] { notesOf(0.002, 0.005); }, "cells of 5 mm would lose 9"));
  CHECK(test::refuses([] { notesOf(0.002, 0.005); }, "mm, which keeps 98 %"));
  CHECK(test::tells(toldLast(notesOf(0.0045, 0.005)), "cells of 5 mm lose"));
  CHECK(test::tells(toldLast(notesOf(0.0045, 0.005)), "--spacing 3.7mm keeps 98 %"));
  CHECK(test::tells(toldLast(notesOf(0.002, 0.0016)), "less than two cells of 1.6 mm"));
  CHECK_FALSE(test::tells(toldLast(notesOf(0.012, 0.005)), "tissue, behind"));
}

TEST_CASE("a model in millimetres is refused with its unit, whatever refuses it") {
  const ModelReader inMillimetres = [](const std::filesystem::path& path, const std::string&) {
    return Model{path.string(), "STL", {{"", boxMesh({{0, 0, 0}, {200, 150, 100}})}}};
  };
  Scenario scenario;
  scenario.organs.resize(1);
  OrganSource& source = scenario.organs[0].source;
  source.file = "scan.stl";
  source.spacing = 0.005;
  const auto refuses = [&](const std::string& what) {
    return test::refuses([&] { loadOrgans(scenario, inMillimetres); }, what) &&
           test::refuses([&] { loadOrgans(scenario, inMillimetres); },
                         "in mm it would be 0.2 m: add --unit mm");
  };
  CHECK(refuses("needs 2.4e+13 cells"));
  source.spacing.reset();
  source.dims = Vec3i(8, 8, 8);
  Region ball;
  ball.shape = Region::Shape::Ball;
  ball.centre = Vec3(0, 0.1, 0);
  ball.radius = 0.01;
  source.labels.push_back({1, "tumour", ball});
  CHECK(refuses("marks no particle"));
  source.labels.clear();
  source.unit = 1e-3;
  CHECK(loadOrgans(scenario, inMillimetres).size() == 1);
  // What is far smaller than a cell is lost.
  source.unit = 1e-6;
  source.dims.reset();
  source.spacing = 0.005;
  CHECK(refuses("cells of 5 mm would lose 9"));
}
