// Scissors part the tissue between their blades when they close, and nothing else.
#include <doctest/doctest.h>

#include "geometry/topology.h"
#include "simulation/simulation.h"
#include "support/elastic_block.h"
#include "support/test_tools.h"
#include "tissue/elastic/elastic_tissue.h"
#include "tools/registry.h"

using namespace resect;

namespace {

constexpr double kSlabSpacing = 0.008;

// Blades 40 mm long that open to 0.6 rad in the Y-Z plane; thin, so that they push little.
std::unique_ptr<Tool> scissors(const char* response = "") {
  ToolModel model;
  model.name = model.kind = "scissors";
  model.response = response;
  model.mesh = boxMesh({{-0.0005, -0.002, 0.04}, {0.0005, 0.002, 0.12}});
  model.edge = {{0, 0, 0}, {0, 0, 0.02}, {0, 0, 0.04}};
  model.jaws = {{0, 0, 0.045}, Vec3::UnitX(), 0.6};
  return makeTool(std::move(model));
}

// A slab of 11 x 9 x 5 cells on the table whose long side is along X.
Simulation slab(std::unique_ptr<Tool> tool) {
  return test::elasticBlock({11, 5, 9}, kSlabSpacing, std::move(tool));
}

FrameInput scissorsInput(const Vec3& tip, double squeeze) {
  FrameInput frame;
  frame.tools.push_back({{tip, Eigen::Quaterniond::Identity()}, true, squeeze});
  return frame;
}

// From squeeze `from` to `to` at one place; returns the bonds that were cut.
std::int64_t squeeze(Simulation& simulation, const Vec3& tip, double from, double to) {
  constexpr int kFrames = 12;
  std::int64_t severed = 0;
  for (int i = 0; i <= kFrames; ++i) {
    const StepReport report = simulation.step(scissorsInput(tip, from + (to - from) * i / kFrames));
    CHECK(report.faults.empty());
    severed += report.severed;
  }
  return severed;
}

// Bonds that cross the plane between the columns x and x + 1 of the cells `holds` accepts.
template <typename Holds>
int across(const Simulation& simulation, int x, Holds holds) {
  const Lattice& lattice = simulation.organ().rest.lattice;
  int count = 0;
  for (std::int64_t c = 0; c < lattice.cellCount(); ++c)
    for (int d = 0; d < kDirections; ++d)
      if (lattice.cell(c).x() == x && offsetAlong(d, 0) == 1 && holds(lattice.cell(c)))
        count += simulation.tissue().bonds(c) >> d & 1;
  return count;
}

// The blades straddle the slab's near end (z from 0), their plane between columns 4 and 5.
const Vec3 kTip(5 * kSlabSpacing + 1e-5, 2.5 * kSlabSpacing, 4 * kSlabSpacing);

}  // namespace

TEST_CASE("scissors cut the tissue between their blades as they close, and take nothing away") {
  Simulation simulation = slab(scissors());
  const std::int64_t particles = simulation.organ().particles;
  CHECK(squeeze(simulation, kTip, 0, 0) == 0);
  CHECK(squeeze(simulation, kTip, 0, 1) > 10);
  CHECK(simulation.organ().particles == particles);
  const Topology form = topology(simulation.surfaceMesh());
  CHECK(form.closed());
  CHECK(form.oriented());
  // Between the blades, which are 20 mm apart 5 mm behind their tips: the middle layer is parted
  // ...
  const auto between = [](const Vec3i& c) { return c.y() == 2 && c.z() >= 5; };
  const auto ahead = [](const Vec3i& c) { return c.z() <= 2; };
  CHECK(across(simulation, 4, between) < across(slab(scissors()), 4, between) / 2);
  // ... and what lies ahead of the tips is whole.
  CHECK(across(simulation, 4, ahead) == across(slab(scissors()), 4, ahead));
}

TEST_CASE("scissors that open, or stay closed, cut nothing wherever they move") {
  Simulation simulation = slab(scissors());
  CHECK(squeeze(simulation, kTip, 1, 0) == 0);
  std::int64_t severed = 0;
  for (int i = 0; i <= 12; ++i)
    severed += simulation.step(scissorsInput(kTip - Vec3(0, 0, 0.002 * i), 0)).severed;
  CHECK(severed == 0);
}

TEST_CASE("many snips in a row part the slab into two bodies") {
  Simulation simulation = slab(scissors());
  for (const double height : {0.5, 2.5, 4.5})
    for (double z = 7; z > -3; z -= 1.5) {
      const Vec3 tip(5 * kSlabSpacing + 1e-5, height * kSlabSpacing, z * kSlabSpacing);
      squeeze(simulation, tip, 0, 1);
    }
  CHECK(across(simulation, 4, [](const Vec3i&) { return true; }) == 0);
}

TEST_CASE("a squeeze that is not a number opens the jaws and harms nothing") {
  Simulation simulation = slab(scissors());
  const StepReport report = simulation.step(scissorsInput(kTip, std::nan("")));
  CHECK(report.severed == 0);
  CHECK(simulation.tools()[0].way.to.squeeze == 0);
}

TEST_CASE("scissors set to the thesis's response remove what they touch") {
  Simulation simulation = slab(scissors("remove"));
  // The shank over a column of cells' centres.
  simulation.step(scissorsInput(kTip + Vec3(0.5 * kSlabSpacing, 0, -0.03), 0));
  CHECK(simulation.organ().removed > 0);
}
