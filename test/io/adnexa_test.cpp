// What hangs on the built-in liver follows its tissue.
#include "operation/adnexa/adnexa.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "collision/swept_blade.h"
#include "io/operation_setup.h"
#include "io/plain_mesh.h"
#include "io/scenario/scenario_file.h"
#include "operation/live/present_surface.h"
#include "organ/builtin/builtin_liver.h"

using namespace resect;

namespace {

Scenario liver(const std::string& organ, const std::string& tissue = "elastic") {
  return parseScenario("title = \"Liver\"\nduration = 1\n[organ]\nspacing = \"10mm\"\n" + organ +
                           "[organ.tissue]\nmodel = \"" + tissue + "\"\n",
                       "test.toml");
}

const std::string kVessels = "vessels = \"built-in\"\n";
const std::string kTurned = kVessels + "rotation = { axis = [0.3, 0.2, -0.9], degrees = 140 }\n";

Simulation simulated(Scenario scenario) {
  Simulation simulation = makeSimulation(scenario, readPlainMesh);
  simulation.keepLook();
  return simulation;
}

// Distance from the organ's present surface to the nearest of its vertices, m.
double offSurface(const Simulation& simulation, const Vec3f& p) {
  float least = 1;
  for (const Vec3f& q : presentSurface(simulation).points)
    least = std::min(least, (p - q).squaredNorm());
  return std::sqrt(double(least));
}

// The largest of these distances for the points where the falciform ligament meets the liver.
double ligamentOff(const Simulation& simulation, const SurfaceCopy& shapes) {
  double most = 0;
  for (std::size_t i = 0; i < shapes.points.size(); ++i)
    if (shapes.cut[i] == float(int(AdnexaLook::Ligament)))
      most = std::max(most, offSurface(simulation, shapes.points[i]));
  return most;
}

int holes(const SurfaceCopy& shapes) {
  return int(std::ranges::count(shapes.triangles, Triangle{0, 0, 0}));
}

void step(Simulation& simulation, int frames, const std::vector<TissueEdit>& edits = {}) {
  StepReport report;
  for (int i = 0; i < frames; ++i) {
    FrameInput input;
    input.duration = 1.0 / 60;
    if (i == 0) input.edits = edits;
    simulation.step(input, report);
  }
}

}  // namespace

TEST_CASE("adnexa sit on the built-in liver however it lies, and follow it as it moves") {
  for (const std::string& organ : {kVessels, kTurned, std::string()}) {
    Simulation simulation = simulated(liver(organ));
    Adnexa adnexa;
    const auto atRest = adnexa.follow(simulation);
    REQUIRE(atRest);
    CHECK(holes(*atRest) == 0);
    CHECK(ligamentOff(simulation, *atRest) < 0.007);  // vertices are half a cell apart
    CHECK(adnexa.follow(simulation) == atRest);       // nothing moved
    step(simulation, 40);                             // it sinks
    const auto later = adnexa.follow(simulation);
    double moved = 0;
    for (std::size_t i = 0; i < later->points.size(); ++i)
      moved = std::max(moved, double((later->points[i] - atRest->points[i]).norm()));
    CHECK(moved > 0.005);
    CHECK(holes(*later) == 0);
    CHECK(ligamentOff(simulation, *later) < 0.008);
    for (const Vec3f& n : later->normals) CHECK(n.norm() == doctest::Approx(1).epsilon(1e-4));
  }
}

TEST_CASE("adnexa whose tissue is removed are no longer drawn") {
  Simulation simulation = simulated(liver(kVessels, "still"));
  Adnexa adnexa;
  const auto before = adnexa.follow(simulation);
  REQUIRE(before);
  // All tissue within 3 cm of a point of the ligament.
  std::size_t middle = 0;
  for (std::size_t i = 0; i < before->points.size(); ++i)
    if (before->cut[i] == float(int(AdnexaLook::Ligament)) && middle == 0) middle = i + 180;
  const Organ& organ = simulation.organ();
  std::vector<TissueEdit> edits;
  for (std::int64_t i = 0; i < std::int64_t(organ.alive.size()); ++i)
    if (organ.alive[std::size_t(i)] &&
        (organ.rest.lattice.centre(organ.rest.lattice.cell(i)).cast<float>() -
         before->points[middle])
                .norm() < 0.03)
      edits.push_back({0, -1, RemoveCell{i}});
  REQUIRE(edits.size() > 10);
  step(simulation, 1, edits);
  const auto after = adnexa.follow(simulation);
  CHECK(holes(*after) > 20);
  CHECK(holes(*after) < int(after->triangles.size()) / 2);
}

TEST_CASE("a stroke through the liver cuts the ligament that crosses its way, and nothing else") {
  constexpr std::size_t kAcross = 6;  // points from the liver to the edge of the fold
  for (const std::string& organ : {kVessels, kTurned}) {
    Simulation simulation = simulated(liver(organ));
    Adnexa adnexa;
    const auto before = adnexa.follow(simulation);
    REQUIRE(before);
    const auto point = [&](std::size_t row, std::size_t up) {
      REQUIRE(int(before->cut[row * kAcross + up]) == int(AdnexaLook::Ligament));
      return Vec3(before->rest[row * kAcross + up].cast<double>());
    };
    const Vec3 at = 0.5 * (point(40, 0) + point(41, 0)), up = (point(40, 5) - at).normalized();
    const Vec3 across = (point(44, 0) - point(37, 0)).cross(up).normalized();
    const auto stroke = [&](double depth) {
      const Vec3 high[] = {at + 0.02 * up - 0.02 * across, at + 0.02 * up + 0.02 * across};
      const Vec3 low[] = {high[0] - (0.02 + depth) * up, high[1] - (0.02 + depth) * up};
      step(simulation, 1, {{0, -1, Incision{ruledBlade(high, low)}}});
      return adnexa.follow(simulation);
    };
    CHECK(holes(*stroke(-0.002)) == 0);  // it does not reach the liver
    const auto after = stroke(0.03);
    // A few rows at most, and one at least, from the liver to the edge.
    CHECK(holes(*after) >= 2 * int(kAcross - 1));
    CHECK(holes(*after) <= 10 * int(kAcross - 1));
    for (std::size_t t = 0; t < after->triangles.size(); ++t)
      if (after->triangles[t] == Triangle{0, 0, 0})
        CHECK((before->rest[std::size_t(before->triangles[t][0])].cast<double>() - at).norm() <
              0.03);
    // On both sides the rest of the fold still stands on the liver.
    step(simulation, 20);
    CHECK(ligamentOff(simulation, *adnexa.follow(simulation)) < 0.010);
  }
}

TEST_CASE("only the built-in liver has adnexa, and its place is found however it lies") {
  for (const char* spacing : {"12mm", "8mm", "6mm"})
    for (const double degrees : {0.0, 33.0, 170.0}) {
      Scenario scenario =
          liver(fmt::format("vessels = \"built-in\"\nsettle = false\n"
                            "rotation = {{ axis = [0.3, 0.2, -0.9], degrees = {} }}\n",
                            degrees),
                "still");
      scenario.organs[0].source.spacing = std::stod(spacing) / 1000;
      const Simulation simulation = makeSimulation(scenario, readPlainMesh);
      const auto pose = builtinLiverPose(simulation.organ().rest);
      REQUIRE(pose);
      // The root of the portal vein, as it comes with the liver.
      const Vec3 root = builtinLiverVessels().hilumOut;
      const Vec3 place = simulation.organ().map->anatomy.segments[0].start;
      CHECK(holes(*Adnexa().follow(simulation)) == 0);
      CHECK((*pose * root - place).norm() < 0.25 * *scenario.organs[0].source.spacing);
    }
  Scenario scenario = liver("source = \"gallbladder\"\n", "still");
  CHECK_FALSE(Adnexa().follow(makeSimulation(scenario, readPlainMesh)));
}
