// The logged edits of a run, applied without its instruments, have the same effect.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>

#include "base/error.h"
#include "geometry/topology.h"
#include "organ/parts/bodies.h"
#include "simulation/simulation.h"
#include "support/blades.h"
#include "support/elastic_block.h"
#include "support/test_tools.h"
#include "tissue/stencil.h"

using namespace resect;

namespace {

constexpr double kBlockSpacing = 0.008;
const Vec3i kBlockDims(14, 6, 10);

std::unique_ptr<Tool> hook() {
  ToolModel model;
  model.name = model.kind = "hook";
  model.mesh = boxMesh({{-0.001, -0.001, 0}, {0.001, 0.001, 0.1}});
  model.hook = {{0, -0.01, 0.01}, {0, 0, 0}, {0, 0.01, 0.01}};
  model.slipForce = 1.2;
  return makeTool(std::move(model));
}

// A body that acts no more when not `acting`.
std::vector<std::unique_ptr<Tool>> tools(bool acting, std::unique_ptr<Tool> one) {
  std::vector<std::unique_ptr<Tool>> all;
  all.push_back(std::move(one));
  if (!acting)
    for (const auto& tool : all) tool->parts.clear();
  return all;
}

Simulation elastic(bool acting) {
  return test::elasticBlock(kBlockDims, kBlockSpacing, tools(acting, hook()));
}
Simulation stillBlock(bool acting) {
  return {makeOrgan(test::fullBlock(kBlockDims, kBlockSpacing), {}),
          tools(acting, test::thinScalpel())};
}
Simulation still(bool acting) {
  return {makeOrgan(test::ball(20), {}), tools(acting, test::ballTool(0.008))};
}

Simulation withoutTools(bool moves) {
  if (moves)
    return test::elasticBlock(kBlockDims, kBlockSpacing, std::vector<std::unique_ptr<Tool>>());
  return {makeOrgan(test::fullBlock(kBlockDims, kBlockSpacing), {}), {}};
}

ToolInput at(const Vec3& p, bool inHand = true) {
  return {{p, Eigen::Quaterniond::Identity()}, inHand};
}

// What an operation did, by kind of edit.
struct Log {
  std::vector<std::vector<TissueEdit>> frames;
  std::vector<std::uint64_t> hashes;
  std::array<int, std::variant_size_v<decltype(TissueEdit::what)>> kinds{};
  template <typename Kind>
  int count() const {
    return kinds[TissueEdit{0, -1, Kind()}.what.index()];
  }
};

Log operate(Simulation& simulation, const std::vector<FrameInput>& inputs) {
  Log log;
  for (const FrameInput& input : inputs) {
    const StepReport report = simulation.step(input);
    CHECK(report.faults.empty());
    log.frames.push_back(report.edits);
    // What still tissue causes are cuts by edges.
    if (!simulation.moves())
      std::ranges::copy(report.caused, std::back_inserter(log.frames.back()));
    log.hashes.push_back(simulation.stateHash());
    for (const TissueEdit& edit : log.frames.back()) ++log.kinds[edit.what.index()];
  }
  return log;
}

// The frames after which the second simulation was not as the first one.
int otherFrames(Simulation& simulation, std::vector<FrameInput> inputs, const Log& log) {
  int other = 0;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    inputs[i].edits = log.frames[i];
    simulation.step(inputs[i]);
    other += simulation.stateHash() != log.hashes[i];
  }
  return other;
}

std::vector<FrameInput> throughTheBall() {
  std::vector<FrameInput> inputs(30);
  for (int i = 0; i < 30; ++i)
    inputs[std::size_t(i)].tools = {at(Vec3(0.055 + 0.001 * i, 0.09 - 0.003 * i, 0.08), i < 25)};
  inputs[12].iso = 40.f;
  return inputs;
}

// The hook goes in at one end, pulls and is put away.
std::vector<FrameInput> pull() {
  std::vector<FrameInput> inputs(60);
  const Vec3 over(3 * kBlockSpacing, 5 * kBlockSpacing, 10 * kBlockSpacing + 0.02);
  const Vec3 in = over - Vec3(0, 0, 0.035);
  for (int i = 0; i < 60; ++i) {
    const Vec3 pulled =
        i <= 20 ? Vec3(over + (in - over) * (i / 20.0)) : Vec3(in + Vec3(0, 0, 0.0003 * (i - 20)));
    inputs[std::size_t(i)].tools = {at(pulled, i < 55)};
  }
  return inputs;
}

// The scalpel goes down through the middle.
std::vector<FrameInput> cut() {
  std::vector<FrameInput> inputs(60);
  const Vec3 start(9 * kBlockSpacing, 6 * kBlockSpacing + 0.012, -0.005);
  for (int i = 0; i < 60; ++i) inputs[std::size_t(i)].tools = {at(start - Vec3(0, 0.0009 * i, 0))};
  return inputs;
}

}  // namespace

TEST_CASE("the edits of a remover on still tissue do without it what they did with it") {
  const std::vector<FrameInput> inputs = throughTheBall();
  Simulation first = still(true), second = still(false), idle = still(false);
  const Log log = operate(first, inputs);
  CHECK(log.count<RemoveCell>() > 50);
  CHECK(otherFrames(second, inputs, log) == 0);
  CHECK(second.stateHash() == first.stateHash());
  CHECK(second.organ().removed == first.organ().removed);
  operate(idle, inputs);
  CHECK(idle.stateHash() != first.stateHash());
}

TEST_CASE("the edits of a hook on elastic tissue do without it what they did with it") {
  const std::vector<FrameInput> inputs = pull();
  Simulation first = elastic(true), second = elastic(false), idle = elastic(false);
  const Log log = operate(first, inputs);
  CHECK(log.count<Grip>() > 3);
  CHECK(log.count<Release>() > 0);
  CHECK(otherFrames(second, inputs, log) == 0);
  CHECK(second.stateHash() == first.stateHash());
  operate(idle, inputs);
  CHECK(idle.stateHash() != first.stateHash());
}

TEST_CASE("what a scalpel has cut in still tissue is cut alike by edits without it") {
  const std::vector<FrameInput> inputs = cut();
  Simulation first = stillBlock(true), second = stillBlock(false);
  Log log = operate(first, inputs);
  CHECK(log.count<Incision>() > 3);
  CHECK(otherFrames(second, inputs, log) == 0);
  CHECK(second.stateHash() == first.stateHash());
}

TEST_CASE("edits are done with no tool at all, on tissue that moves and that does not") {
  for (const bool moves : {false, true}) {
    Simulation simulation = withoutTools(moves);
    const Lattice& lattice = simulation.organ().rest.lattice;
    const auto cell = [&](int x, int y, int z) { return lattice.index({x, y, z}); };
    FrameInput input;
    for (int y = 0; y < kBlockDims.y(); ++y)
      for (int z = 0; z < kBlockDims.z(); ++z)
        input.edits.push_back({0, -1, RemoveCell{cell(6, y, z)}});
    input.edits.push_back({0, -1, SetLabel{cell(1, 1, 1), 4}});
    StepReport report = simulation.step(input);
    CHECK(report.removed == kBlockDims.y() * kBlockDims.z());
    CHECK(report.removedVolume == doctest::Approx(60 * std::pow(kBlockSpacing, 3)));
    CHECK(report.edits.size() == input.edits.size());
    CHECK(simulation.organ().label(cell(1, 1, 1)) == 4);
    CHECK(topology(simulation.surfaceMesh()).components == 2);

    input.edits.clear();
    for (int y = 0; y < kBlockDims.y(); ++y)
      for (int z = 0; z < kBlockDims.z(); ++z)
        for (int d = 0; d < kDirections; ++d)
          if (offsetAlong(d, 0) == 1) input.edits.push_back({0, -1, SeverBond{cell(10, y, z), d}});
    report = simulation.step(input);
    CHECK(report.severed > 300);
    CHECK(report.removed == 0);
    CHECK(bodies(simulation.organ()).size() == 3);

    input.edits = {{0, -1, RemoveCell{cell(6, 0, 0)}}};  // gone already
    report = simulation.step(input);
    CHECK(report.removed == 0);
    CHECK(report.severed == 0);
    for (const std::int64_t none : {std::int64_t(-1), lattice.cellCount()}) {
      input.edits = {{0, -1, RemoveCell{cell(1, 1, 1)}}, {0, -1, SeverBond{none, 3}}};
      const std::uint64_t before = simulation.stateHash();
      CHECK_THROWS_WITH_AS(
          simulation.step(input),
          fmt::format("an edit is of cell {}; give 0 to {}", none, lattice.cellCount() - 1).c_str(),
          Error);
      CHECK(simulation.stateHash() == before);
    }
  }
}

TEST_CASE("edits are done before those of the tools in the same frame") {
  Simulation first = still(true), second = still(true);
  std::vector<FrameInput> inputs = throughTheBall();
  std::size_t frame = 0;
  std::vector<TissueEdit> edits;
  for (; edits.empty(); ++frame) edits = first.step(inputs[frame]).edits;
  for (std::size_t i = 0; i + 1 < frame; ++i) second.step(inputs[i]);
  inputs[frame - 1].edits = {edits[0]};
  const StepReport report = second.step(inputs[frame - 1]);
  CHECK(report.removed == std::int64_t(edits.size()));
  REQUIRE(report.edits.size() == edits.size() + 1);
  for (const std::size_t i : {0, 1})
    CHECK(std::get<RemoveCell>(report.edits[i].what).cell ==
          std::get<RemoveCell>(edits[0].what).cell);
  CHECK(second.stateHash() == first.stateHash());
}

TEST_CASE("a tool whose pose is not a number rests and pushes no more than one that rests") {
  const auto run = [](bool number) {
    Simulation simulation = elastic(true);
    for (const FrameInput& input : pull()) {
      FrameInput now = input;
      const bool odd = simulation.frame() == 30;
      if (odd) {
        now.tools[0].pose = simulation.tools()[0].pose();
        now.tools[0].squeeze = simulation.tools()[0].way.to.squeeze;
        if (!number) now.tools[0].pose.position.x() = std::numeric_limits<double>::quiet_NaN();
      }
      CHECK(simulation.step(now).faults.empty() == (number || !odd));
    }
    return simulation.stateHash();
  };
  CHECK(run(false) == run(true));
}

TEST_CASE("a report that is used again tells nothing of the frame before") {
  Simulation simulation = withoutTools(true);
  StepReport report;
  FrameInput input;
  simulation.step(input, report);
  CHECK(report.tissue[0].substeps > 0);
  input.duration = 0;
  simulation.step(input, report);
  CHECK(report.tissue[0].substeps == 0);
  CHECK(report.tissue[0].force.empty());
}

TEST_CASE("a joint goes with the cell that it holds, and with it alone") {
  std::vector<OperatedOrgan> organs;
  std::vector<JoinedOrgan> joined;
  for (const int n : {0, 1}) {
    Discretization cells = test::fullBlock({5, 4, 4}, kBlockSpacing);
    cells.lattice.origin = Vec3(5 * n * kBlockSpacing, 0.5 * kBlockSpacing, 0);
    auto tissue = std::make_unique<ElasticTissue>(
        TissueCells{cells.lattice, cells.inside, {liverTissue()}, {}}, TissueSettings());
    organs.push_back(
        operatedOrgan(n == 0 ? "a" : "b", makeOrgan(std::move(cells), {}), std::move(tissue)));
  }
  for (const int n : {0, 1})
    joined.push_back(
        {n, &organs[std::size_t(n)].organ.rest.lattice, organs[std::size_t(n)].tissue.get()});
  const std::vector<TissueJoint> joints =
      joinNear(joined[0], joined[1], 1.01 * kBlockSpacing, 50, 1e-3);
  REQUIRE(joints.size() == 16);
  Simulation simulation(std::move(organs), {}, joints);
  FrameInput input;
  simulation.step(input);
  CHECK(simulation.joints().size() == 16);
  input.edits = {{0, -1, RemoveCell{joints[3].cell[0]}},
                 {1, -1, RemoveCell{joints[7].cell[1]}},
                 {0, -1, RemoveCell{0}}};
  CHECK(simulation.step(input).removed == 3);
  REQUIRE(simulation.joints().size() == 14);
  for (const TissueJoint& joint : simulation.joints()) {
    CHECK(joint.cell[0] != joints[3].cell[0]);
    CHECK(joint.cell[1] != joints[7].cell[1]);
  }
  input.edits.clear();
  for (int i = 0; i < 30; ++i) CHECK(simulation.step(input).faults.empty());
  CHECK(simulation.joints().size() == 14);
}
