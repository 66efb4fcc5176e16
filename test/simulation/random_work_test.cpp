// Elastic tissue under long random work.
//
// Instruments work on a liver at random: pressed, dragged, hooked, cut, snipped, driven through and
// taken elsewhere at once. RESECT_WORK_SECONDS: how long, in simulated seconds (8);
// RESECT_WORK_SEED.
#include <doctest/doctest.h>

#include <cstdlib>
#include <numbers>

#include "base/random.h"
#include "geometry/measures.h"
#include "geometry/resting_pose.h"
#include "geometry/topology.h"
#include "organ/builtin/builtin_liver.h"
#include "organ/discretize.h"
#include "simulation/simulation.h"
#include "support/environment.h"
#include "support/test_tools.h"
#include "tissue/elastic/elastic_tissue.h"

using namespace resect;

namespace {

// Of about the size and the response of those in data/tools; handles along Z.
std::vector<std::unique_ptr<Tool>> instruments() {
  std::vector<std::unique_ptr<Tool>> tools;
  const auto add = [&](const char* kind, TriangleMesh mesh, auto describe) {
    tools.push_back(test::describedTool(kind, std::move(mesh), describe));
  };
  add("scalpel", boxMesh({{-0.0003, -0.008, 0}, {0.0003, 0.003, 0.15}}), [](ToolModel& m) {
    m.edge = {{0, -0.008, 0}, {0, -0.0082, 0.02}, {0, -0.008, 0.04}};
    m.bluntness = 0.2;  // so that it cuts, wherever it passes
  });
  add("hook", boxMesh({{-0.0015, -0.0015, 0}, {0.0015, 0.0015, 0.15}}), [](ToolModel& m) {
    m.hook = {{0, -0.01, 0.01}, {0, 0, 0}, {0, 0.01, 0.01}};
    m.slipForce = 1.2;
  });
  add("baton", boxMesh({{-0.006, -0.006, 0}, {0.006, 0.006, 0.15}}), [](ToolModel&) {});
  add("scissors", boxMesh({{-0.0005, -0.002, 0.04}, {0.0005, 0.002, 0.15}}), [](ToolModel& m) {
    m.edge = {{0, 0, 0}, {0, 0, 0.02}, {0, 0, 0.04}};
    m.jaws = {{0, 0, 0.045}, Vec3::UnitX(), 0.6};
    m.bluntness = 0.2;
  });
  return tools;
}

// One piece of work: an instrument moves along straight lines without turning, or is somewhere else
// at once.
struct Act {
  int tool;
  Eigen::Quaterniond rotation;
  std::vector<Vec3> way;
  double speed;    // m/s
  double squeeze;  // closings per second
};

Act randomAct(Random& random, int tools, const Aabb& organ) {
  const auto within = [&](double low, double high) {
    return Vec3(random.uniform(organ.min.x(), organ.max.x()),
                random.uniform(low, high) * organ.max.y(),
                random.uniform(organ.min.z(), organ.max.z()));
  };
  Act act;
  act.tool = random.below(tools);
  const double tilt = random.uniform(0, 1), turn = random.uniform(0, 2 * std::numbers::pi);
  act.rotation = Eigen::AngleAxisd(turn, Vec3::UnitY()) *
                 Eigen::AngleAxisd(tilt - 0.5 * std::numbers::pi, Vec3::UnitX());
  act.way = {within(1.4, 1.6)};
  act.way.push_back(within(0.1, 0.9));
  for (int i = random.below(3); i > 0; --i)
    act.way.push_back(act.way.back() + 0.06 * (within(0, 1) - within(0, 1)).normalized());
  act.way.push_back(within(1.4, 1.6));
  act.speed = random.below(8) == 0 ? 1 : random.uniform(0.05, 0.4);
  act.squeeze = random.uniform(0.5, 3);
  return act;
}

}  // namespace

TEST_CASE("random work on a liver: all numbers finite, faults mended, no energy from nowhere") {
  const double seconds = test::numberFrom("RESECT_WORK_SECONDS", 8);
  Random random(std::uint64_t(test::numberFrom("RESECT_WORK_SEED", 1)));
  TriangleMesh mesh = builtinLiver(0.004);
  const Eigen::Quaterniond rest = restingRotation(mesh);
  for (Vec3& p : mesh.points) p = rest * p;
  const Vec3 lift(0, -bounds(mesh).min.y() + 0.001, 0);
  for (Vec3& p : mesh.points) p += lift;
  Discretization cells = discretize(mesh, latticeForSpacing(bounds(mesh), 0.008));
  const std::int64_t particles = cells.particleCount();
  auto owned = std::make_unique<ElasticTissue>(
      TissueCells{cells.lattice, cells.inside, {liverTissue()}, {}}, TissueSettings{});
  ElasticTissue& tissue = *owned;
  const Aabb box = bounds(mesh);
  Simulation simulation(makeOrgan(std::move(cells), {}), instruments(), std::move(owned));
  const int tools = int(simulation.tools().size());

  const double start = tissue.energy().total();
  double before = start, work = 0, worked = 0, lost = 0, excess = 0;  // J
  std::int64_t severed = 0, torn = 0, retries = 0, faults = 0, acts = 0;
  int faultsInARow = 0;
  Act act;
  std::size_t leg = 0;
  Vec3 at = Vec3::Zero();
  for (std::int64_t frame = 0; double(frame) / 60 < seconds; ++frame) {
    FrameInput input;
    input.tools.assign(std::size_t(tools), {{Vec3(0, 1, 0), {1, 0, 0, 0}}, false, 0});
    Vec3 moved = Vec3::Zero();
    bool jumps = false;
    if (frame > 30) {  // it has come to lie
      jumps = leg + 1 >= act.way.size();
      if (jumps) {
        act = randomAct(random, tools, box);
        leg = 0;
        ++acts;
        // Sometimes inside the tissue at once.
        at = act.way[random.below(10) == 0 ? 1 : 0];
      } else {
        const Vec3 left = act.way[leg + 1] - at;
        const double step = act.speed / 60;
        moved = left.norm() <= step ? left : Vec3(left * (step / left.norm()));
        at += moved;
        if (left.norm() <= step) ++leg;
      }
      const double phase = std::fmod(simulation.time() * act.squeeze, 1.0);
      input.tools[std::size_t(act.tool)] = {{at, act.rotation}, true, std::abs(2 * phase - 1)};
    }
    const StepReport report = simulation.step(input);
    severed += report.severed;
    torn += report.torn;
    retries += report.tissue[0].retries;
    const bool fault = !report.faults.empty();
    faults += fault;
    faultsInARow = fault ? faultsInARow + 1 : 0;
    REQUIRE(faultsInARow < 30);
    const double energy = tissue.energy().total();
    REQUIRE(std::isfinite(energy));
    if (frame > 30) {
      // What an instrument does that is there at once counts as its work.
      const double done = jumps ? std::max(energy - before, 0.0)
                                : -report.toolForce[std::size_t(act.tool)].dot(moved);
      work += done;
      worked += std::abs(done);
    }
    before = energy;
    // What is lost to damping, friction and cuts never comes back.
    lost = std::max(lost, start + work - energy);
    excess = std::max(excess, lost - (start + work - energy));
    if (frame % 60 != 59) continue;
    for (const Vec3f& p : simulation.surfacePoints()) REQUIRE(p.allFinite());
    const Topology shape = topology(simulation.surfaceMesh());
    REQUIRE(shape.closed());
    REQUIRE(shape.oriented());
    REQUIRE(simulation.organ().particles == particles);
  }
  MESSAGE(acts << " acts in " << seconds << " s: " << severed << " bonds cut, " << torn << " torn, "
               << retries << " frames begun again, " << faults << " faults; work " << work
               << " J, lost " << lost << " J, of which " << excess << " J came back");
  CHECK(acts > 1);
  CHECK(excess < 0.01 * worked);
}
