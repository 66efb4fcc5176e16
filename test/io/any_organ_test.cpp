// The scenario `cut` on twelve organs, as they come and turned.
#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>
#include <vector>

#include "geometry/measures.h"
#include "geometry/topology.h"
#include "io/data_folder.h"
#include "io/operation_setup.h"
#include "io/plain_mesh.h"
#include "io/scenario/scenario_file.h"
#include "operation/run.h"
#include "support/organs/twelve_organs.h"
#include "support/sentence.h"

using namespace resect;

namespace {

// The removed cells, and how many of them hang together by faces, edges or corners at most.
struct Groove {
  std::int64_t removed = 0, together = 0;
  Aabb box;  // of their centres, m
};

Groove grooveOf(const Organ& organ) {
  const Lattice& lattice = organ.rest.lattice;
  std::vector<std::uint8_t> open(std::size_t(lattice.cellCount()));
  Groove groove;
  for (std::size_t c = 0; c < open.size(); ++c) {
    open[c] = organ.rest.inside[c] && !organ.alive[c];
    if (!open[c]) continue;
    ++groove.removed;
    groove.box.grow(lattice.centre(lattice.cell(std::int64_t(c))));
  }
  for (std::size_t c = 0; c < open.size(); ++c) {
    if (!open[c]) continue;
    std::int64_t size = 0;
    std::vector<std::int64_t> next = {std::int64_t(c)};
    open[c] = 0;
    while (!next.empty()) {
      const Vec3i at = lattice.cell(next.back());
      next.pop_back();
      ++size;
      for (int i = 0; i < 27; ++i) {
        const Vec3i to = at + Vec3i(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        if ((to.array() < 0).any() || (to.array() >= lattice.dims.array()).any()) continue;
        const std::int64_t cell = lattice.index(to);
        if (!open[std::size_t(cell)]) continue;
        open[std::size_t(cell)] = 0;
        next.push_back(cell);
      }
    }
    groove.together = std::max(groove.together, size);
  }
  return groove;
}

}  // namespace

TEST_CASE("twelve organs are closed, of a human's size, and cut draws one groove over each") {
  const Eigen::Quaterniond turns[] = {
      Eigen::Quaterniond::Identity(),
      Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Vec3(0.3, 1, 0.2).normalized())),
      Eigen::Quaterniond(Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitY()))};
  for (const std::string name : test::kTwelveOrgans) {
    CAPTURE(name);
    const test::BroughtOrgan organ = test::broughtOrgan(name);
    const Topology topology = resect::topology(organ.mesh);
    CHECK(topology.closed());
    CHECK(topology.oriented());
    CHECK(1e6 * volume(organ.mesh) > organ.least);
    CHECK(1e6 * volume(organ.mesh) < organ.most);
    // With so many cells that a wall has two.
    const double spacing =
        std::min(organ.hollow ? 0.0025 : 0.006, std::cbrt(volume(organ.mesh) / 3000));
    for (const Eigen::Quaterniond& turn : turns) {
      CAPTURE(turn.coeffs());
      Scenario scenario = readScenario(findDataFile("cut", "scenarios", ".toml"));
      OrganSource& source = scenario.organs[0].source;
      source.file = "brought.ply";
      source.pose.rotation = turn;
      source.spacing = spacing;
      Simulation simulation = makeSimulation(scenario, [&](const auto& path, const auto&) {
        return path == "brought.ply" ? Model{"brought.ply", "PLY", {{"", organ.mesh}}}
                                     : readPlainMesh(path);
      });
      const RunSummary summary = runScenario(simulation, scenario);
      CHECK(summary.touched);
      CHECK(summary.surface.closed);
      const Groove groove = grooveOf(simulation.organ());
      CHECK(groove.removed >= 5);
      // The wall of a hollow organ is opened where the blade enters it and where it leaves it.
      CHECK(double(groove.together) > (organ.hollow ? 0.45 : 0.9) * double(groove.removed));
      // It is a groove: long from back to front, narrow across.
      CHECK(groove.box.size().x() < 1.5 * spacing);
      CHECK(groove.box.size().z() > 3 * groove.box.size().x());
      CHECK(summary.ledger.tissue().removed.volume < 0.15 * volume(organ.mesh));
      // The way keeps a surgeon's speed, whatever the organ's size.
      const std::vector<ToolKey>& keys = scenario.tools[0].keys;
      for (std::size_t i = 1; i < keys.size(); ++i)
        CHECK((keys[i].pose.position - keys[i - 1].pose.position).norm() /
                  (keys[i].time - keys[i - 1].time) <
              0.31);
    }
  }
}
