#include "simulation/simulation.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "base/progress.h"
#include "base/random.h"
#include "base/stop.h"
#include "geometry/topology.h"
#include "support/block_organ.h"
#include "support/elastic_block.h"
#include "support/same_at_any_threads.h"
#include "support/surface_look.h"
#include "support/test_tools.h"
#include "tissue/move_tissues.h"
#include "tissue/still_tissue.h"

using namespace resect;

namespace {

Simulation ballAndTool(std::unique_ptr<Tool> tool) {
  std::vector<std::unique_ptr<Tool>> tools;
  tools.push_back(std::move(tool));
  return Simulation(makeOrgan(test::ball(20), {}), std::move(tools));
}

FrameInput toolAt(const Vec3& p, bool inHand = true) {
  FrameInput input;
  input.tools.push_back({{p, Eigen::Quaterniond::Identity()}, inHand});
  return input;
}

}  // namespace

TEST_CASE("a ball pushed through an organ removes what it touches, and the books agree") {
  Simulation simulation = ballAndTool(test::ballTool(0.012));
  const Vec3 middle = simulation.organ().rest.lattice.box().centre();
  const std::int64_t before = simulation.organ().particles;
  const double volumeBefore = simulation.organ().volume();
  std::int64_t removed = 0;
  double removedVolume = 0;
  for (int i = 0; i <= 30; ++i) {
    const StepReport report = simulation.step(toolAt(middle + Vec3(-0.09 + 0.006 * i, 0, 0)));
    CHECK(report.frame == i);
    removed += report.removed;
    removedVolume += report.removedVolume;
  }
  CHECK(removed > 100);
  CHECK(simulation.organ().particles == before - removed);
  CHECK(std::abs((simulation.organ().volume() + removedVolume) / volumeBefore - 1) < 1e-12);
  const Topology t = topology(simulation.organ().surface.mesh());
  CHECK(t.closed());
  CHECK(t.oriented());
  CHECK(simulation.time() == doctest::Approx(31.0 / 60));
}

TEST_CASE("a frame without contact touches no brick") {
  Simulation simulation = ballAndTool(test::ballTool(0.012));
  const StepReport report = simulation.step(toolAt({2, 2, 2}));
  CHECK(report.removed == 0);
  CHECK(report.touchedBricks == 0);
}

TEST_CASE("a tool that lies in the tool box, or is just taken in hand, sweeps nothing on its way") {
  Simulation simulation = ballAndTool(test::ballTool(0.005));
  const Vec3 middle = simulation.organ().rest.lattice.box().centre();
  simulation.step(toolAt(middle - Vec3(1, 0, 0), false));
  CHECK(simulation.step(toolAt(middle, false)).removed == 0);
  CHECK(simulation.step(toolAt(middle + Vec3(1, 0, 0), true)).removed == 0);
  CHECK(simulation.step(toolAt(middle - Vec3(1, 0, 0), true)).removed > 0);
}

TEST_CASE("a pose that is not a number is a fault in the report and changes nothing") {
  Simulation simulation = ballAndTool(test::ballTool(0.005));
  const std::int64_t particles = simulation.organ().particles;
  const StepReport report =
      simulation.step(toolAt(Vec3(0, std::numeric_limits<double>::quiet_NaN(), 0)));
  REQUIRE(report.faults.size() == 1);
  CHECK(simulation.organ().particles == particles);
}

TEST_CASE("the iso level can be changed in any frame; one out of range is a fault") {
  Simulation simulation = ballAndTool(test::ballTool(0.005));
  FrameInput input = toolAt({2, 2, 2});
  input.iso = 30.f;
  simulation.step(input);
  CHECK(simulation.organ().surface.iso() == 30.f);
  input.iso = 200.f;
  CHECK(simulation.step(input).faults.size() == 1);
  CHECK(simulation.organ().surface.iso() == 30.f);
}

TEST_CASE("an iso change in the frame of a cut loses no update of the surface") {
  Simulation simulation = ballAndTool(test::ballTool(0.012));
  simulation.keepLook();
  FrameInput input = toolAt(simulation.organ().rest.lattice.box().centre());
  input.iso = 40.f;
  REQUIRE(simulation.step(input).removed > 0);
  const auto now = simulation.surface();
  const auto anew = test::withLook(simulation.organ().field, 40);
  CHECK(now.mesh.points == anew.mesh.points);
  CHECK(now.mesh.triangles == anew.mesh.triangles);
}

TEST_CASE("the same inputs give the same state hash, on a second run and at 1, 2 and 3 threads") {
  const auto run = [](int) {
    Simulation simulation = ballAndTool(test::boxTool({{-0.001, -0.01, 0}, {0.001, 0.01, 0.1}}));
    const Vec3 middle = simulation.organ().rest.lattice.box().centre();
    Random random(8);
    for (int i = 0; i < 20; ++i)
      simulation.step(
          toolAt(middle + Vec3(random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05), -0.02)));
    return simulation.stateHash();
  };
  test::checkSameAtAnyThreads(run);
}

TEST_CASE("the stage clock gets a lap of every stage in the order of the step") {
  Simulation simulation = ballAndTool(test::ballTool(0.005));
  StageClock clock;
  for (int i = 0; i < 3; ++i) simulation.step(toolAt({2, 2, 2}), &clock);
  const std::vector<std::string> names = {
      "moveTools",   "findContacts",  "actTools",   "applyEdits", "moveTissue", "applyCuts",
      "updateField", "updateSurface", "heatTissue", "flowBlood",  "measure"};
  REQUIRE(clock.stages().size() == names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    CHECK(clock.stages()[i].name == names[i]);
    CHECK(clock.stages()[i].seconds.size() == 3);
  }
}

namespace {

// Tissue whose frame has more substeps than anyone would wait for, stopped from outside in the
// third.
class EndlessTissue final : public StillTissue {
 public:
  EndlessTissue(const Lattice& lattice, std::atomic<bool>& stop)
      : StillTissue(lattice, std::vector<std::uint8_t>(std::size_t(lattice.cellCount()), 1)),
        stop_(stop) {}
  bool moves() const override { return true; }
  int substepsWanted() const override { return std::numeric_limits<int>::max() - 1; }
  bool substep(int number, int) override {
    done = number;
    if (number == 3) stop_ = true;
    return true;
  }
  int done = 0;

 private:
  std::atomic<bool>& stop_;
};

}  // namespace

TEST_CASE("a frame is left between two substeps when work is to stop") {
  const Discretization cells = test::fullBlock({4, 4, 4}, 0.01);
  std::atomic<bool> flag = false;
  EndlessTissue tissue(cells.lattice, flag);
  const StopBy stop(flag);
  TissueStep step;
  CHECK_THROWS_AS(moveTissue(tissue, {}, 1.0 / 60, step), Cancelled);
  CHECK(tissue.done == 3);
}

TEST_CASE(
    "a simulation that was stopped within a frame goes on from a saved state with the same bits") {
  const auto stepOf = [](Simulation& simulation) { simulation.step({1.0 / 60, {}, {}, {}}); };
  Simulation simulation = test::elasticBlock({6, 6, 6}, 0.01, std::vector<std::unique_ptr<Tool>>());
  for (int i = 0; i < 3; ++i) stepOf(simulation);
  const Bytes saved = simulation.save();
  stepOf(simulation);
  const std::uint64_t after = simulation.stateHash();
  simulation.restore(saved);
  {
    const std::atomic<bool> flag = true;
    const StopBy stop(flag);
    CHECK_THROWS_AS(stepOf(simulation), Cancelled);
  }
  simulation.restore(saved);
  stepOf(simulation);
  CHECK(simulation.stateHash() == after);
}
