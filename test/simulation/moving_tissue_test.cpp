// Instruments on elastic tissue, through the whole step.
#include <doctest/doctest.h>

#include "base/parallel.h"
#include "geometry/topology.h"
#include "simulation/simulation.h"
#include "support/elastic_block.h"
#include "support/same_at_any_threads.h"
#include "support/test_tools.h"
#include "tissue/elastic/elastic_tissue.h"

using namespace resect;

namespace {

constexpr double kTissueSpacing = 0.008;

Pose poseAt(const Vec3& p) { return {p, Eigen::Quaterniond::Identity()}; }

std::unique_ptr<Tool> toolOfKind(const char* kind, const char* response = "") {
  ToolModel model;
  model.name = model.kind = kind;
  model.response = response;
  if (model.kind == "scalpel") {
    model.mesh = boxMesh({{-0.0002, -0.008, 0}, {0.0002, 0.002, 0.06}});
    model.edge = {{0, -0.008, 0}, {0, -0.0082, 0.03}, {0, -0.008, 0.06}};
  } else if (model.kind == "hook") {
    model.mesh = boxMesh({{-0.001, -0.001, 0}, {0.001, 0.001, 0.1}});
    model.hook = {{0, -0.01, 0.01}, {0, 0, 0}, {0, 0.01, 0.01}};
    model.slipForce = 1.2;
  } else {
    model.mesh = sphereMesh({0, 0, 0}, 0.012, 24);
  }
  return makeTool(std::move(model));
}

// A block of 14 x 6 x 10 cells on the table.
Simulation blockOnTable(std::unique_ptr<Tool> tool) {
  return test::elasticBlock({14, 6, 10}, kTissueSpacing, std::move(tool));
}

FrameInput handInput(const Vec3& p, bool inHand = true) {
  FrameInput frame;
  frame.tools.push_back({poseAt(p), inHand});
  return frame;
}

// Moves the tool in a straight line in so many frames; sums up what was severed.
std::int64_t drive(Simulation& simulation, const Vec3& from, const Vec3& to, int frames) {
  std::int64_t severed = 0;
  for (int i = 0; i <= frames; ++i) {
    const StepReport report = simulation.step(handInput(from + (to - from) * (double(i) / frames)));
    CHECK(report.faults.empty());
    severed += report.severed;
  }
  return severed;
}

double highest(const Simulation& simulation) {
  double y = -1;
  for (const Vec3& p : simulation.surfaceMesh().points) y = std::max(y, p.y());
  return y;
}

const Vec3 kAway(0.05, 0.3, 0.04);

}  // namespace

TEST_CASE("tissue that is left alone settles on the table with its surface closed") {
  Simulation simulation = blockOnTable(toolOfKind("baton"));
  for (int i = 0; i < 120; ++i) simulation.step(handInput(kAway, false));
  const Topology t = topology(simulation.surfaceMesh());
  CHECK(t.closed());
  CHECK(t.oriented());
  CHECK(highest(simulation) > 5 * kTissueSpacing);
  CHECK(highest(simulation) < 6.01 * kTissueSpacing);
  double lowest = 1;
  for (const Vec3& p : simulation.surfaceMesh().points) lowest = std::min(lowest, p.y());
  CHECK(std::abs(lowest) < 0.1 * kTissueSpacing);
}

TEST_CASE("a baton pushes, feels a force, cuts nothing; the surface gives way and comes back") {
  Simulation simulation = blockOnTable(toolOfKind("baton"));
  const Vec3 above(7 * kTissueSpacing, 6 * kTissueSpacing + 0.02, 5 * kTissueSpacing);
  CHECK(drive(simulation, above, above - Vec3(0, 0.025, 0), 30) == 0);
  CHECK(simulation.tools()[0].force.y() > 0.3);
  CHECK(simulation.tools()[0].feltForce.y() > 0.2);
  CHECK(simulation.organ().removed == 0);
  double under = 1;
  for (const Vec3& p : simulation.surfaceMesh().points)
    if (std::hypot(p.x() - above.x(), p.z() - above.z()) < 0.5 * kTissueSpacing &&
        p.y() > 2 * kTissueSpacing)
      under = std::min(under, p.y());
  CHECK(under < 5.4 * kTissueSpacing);
  for (int i = 0; i < 120; ++i) simulation.step(handInput(kAway, false));
  CHECK(simulation.tools()[0].force == Vec3::Zero());
  CHECK(highest(simulation) > 5.6 * kTissueSpacing);
}

TEST_CASE("a scalpel drawn through parts the block into two bodies and takes nothing away") {
  Simulation simulation = blockOnTable(toolOfKind("scalpel"));
  const std::int64_t particles = simulation.organ().particles;
  // The edge looks down (-Y), 6 cm along z: through the whole height.
  const Vec3 start(7 * kTissueSpacing, 6 * kTissueSpacing + 0.012, -0.005);
  CHECK(drive(simulation, start, start - Vec3(0, 6 * kTissueSpacing + 0.006, 0), 40) > 0);
  const std::int64_t more = drive(simulation, start + Vec3(0, 0, 0.03),
                                  start + Vec3(0, -6 * kTissueSpacing - 0.006, 0.03), 40);
  CHECK(more > 0);
  CHECK(simulation.organ().particles == particles);
  const Lattice& lattice = simulation.organ().rest.lattice;
  int across = 0;
  for (std::int64_t c = 0; c < lattice.cellCount(); ++c)
    for (int d = 0; d < kDirections; ++d)
      if (lattice.cell(c).x() == 6 && offsetAlong(d, 0) == 1)
        across += simulation.tissue().bonds(c) >> d & 1;
  CHECK(across == 0);
}

TEST_CASE("a blade that moves sideways or back out pushes and cuts nothing") {
  Simulation simulation = blockOnTable(toolOfKind("scalpel"));
  CHECK(drive(simulation, {-0.03, 0.03, 0.01}, {0.02, 0.03, 0.01}, 30) == 0);
  CHECK(simulation.tools()[0].force.norm() > 0.01);
}

TEST_CASE("a hook catches while it pulls, lifts, and lets go when the pull is too much") {
  Simulation simulation = blockOnTable(toolOfKind("hook"));
  const Vec3 over(7 * kTissueSpacing, 5 * kTissueSpacing, 10 * kTissueSpacing + 0.02);
  drive(simulation, over, over - Vec3(0, 0, 0.035), 20);
  CHECK(simulation.tissue().gripped(0) == 0);
  const Vec3 in = over - Vec3(0, 0, 0.035);
  drive(simulation, in, in + Vec3(0, 0, 0.002), 20);
  CHECK(simulation.tissue().gripped(0) > 3);
  bool slipped = false;
  Vec3 place = in + Vec3(0, 0, 0.002);
  for (int i = 0; i < 120 && !slipped; ++i) {
    place.z() += 0.002;
    slipped = !simulation.step(handInput(place)).tissue[0].letGo.empty();
  }
  CHECK(slipped);
  CHECK(simulation.tissue().gripped(0) == 0);
}

TEST_CASE("every instrument can take tissue out instead, as in the original system") {
  for (const char* kind : {"baton", "scalpel", "hook"}) {
    Simulation simulation = blockOnTable(toolOfKind(kind, "remove"));
    drive(simulation, {0.052, 0.08, 0.02}, {0.052, 0.02, 0.02}, 20);
    CHECK(simulation.organ().removed > 0);
    CHECK(topology(simulation.surfaceMesh()).closed());
  }
}

TEST_CASE("moving tissue gives the same state hash at 1, 2 and 3 threads and on a second run") {
  const auto run = [](int) {
    Simulation simulation = blockOnTable(toolOfKind("scalpel"));
    const Vec3 start(7 * kTissueSpacing, 6 * kTissueSpacing + 0.01, 0.01);
    drive(simulation, start, start - Vec3(0.004, 0.04, 0), 30);
    return simulation.stateHash();
  };
  test::checkSameAtAnyThreads(run);
}
