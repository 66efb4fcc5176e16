// Is an argument that cannot be right refused in one sentence, and nothing done?
#include <doctest/doctest.h>

#include <limits>

#include "base/random.h"
#include "support/elastic_block.h"
#include "support/sentence.h"
#include "support/test_tools.h"

using namespace resect;
using test::refuses;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kEndless = std::numeric_limits<double>::infinity();
const Vec3i kSmallDims(6, 4, 5);

std::vector<std::unique_ptr<Tool>> twoTools() {
  std::vector<std::unique_ptr<Tool>> tools;
  tools.push_back(test::boxTool({{-0.0002, -0.008, 0}, {0.0002, 0.002, 0.06}}, "scalpel", ""));
  tools.push_back(test::ballTool(0.006));
  return tools;
}

Simulation elasticTwoTools() { return test::elasticBlock(kSmallDims, 0.008, twoTools()); }
Simulation stillTwoTools() {
  return Simulation(makeOrgan(test::fullBlock(kSmallDims, 0.008), {}), twoTools());
}

FrameInput inputFor(const Simulation& simulation) {
  FrameInput input;
  input.tools.resize(simulation.tools().size());
  for (ToolInput& tool : input.tools) tool.pose.position = Vec3(1, 2, 3);
  return input;
}

// Is an input refused that differs from a right one by `change`, with nothing done?
template <typename Change>
bool stepRefused(Change change, const char* what) {
  Simulation simulation = elasticTwoTools();
  FrameInput input = inputFor(simulation);
  change(input);
  const std::uint64_t before = simulation.stateHash();
  const bool refused = refuses([&] { simulation.step(input); }, what);
  return refused && simulation.stateHash() == before && simulation.frame() == 0;
}

}  // namespace

TEST_CASE("a step refuses input for other tools, other organs or no time, and does nothing") {
  CHECK(stepRefused([](FrameInput& i) { i.tools.clear(); }, "input for 0 tools"));
  CHECK(stepRefused([](FrameInput& i) { i.tools.resize(3); }, "input for 3 tools"));
  for (const double wrong : {-1.0 / 60, kNaN, kEndless, 2.0})
    CHECK(stepRefused([&](FrameInput& i) { i.duration = wrong; }, "the frame lasts"));
  for (const std::int32_t wrong : {-1, 1, std::numeric_limits<std::int32_t>::max()})
    CHECK(stepRefused([&](FrameInput& i) { i.edits = {{wrong, -1, RemoveCell{0}}}; }, "for organ"));
  for (const std::int32_t wrong : {-2, 2})
    CHECK(stepRefused([&](FrameInput& i) { i.edits = {{0, wrong, Grip{0, {}}}}; }, "by tool"));
  Pose nowhere;
  nowhere.position.x() = kNaN;
  CHECK(stepRefused([&](FrameInput& i) { i.edits = {{0, 0, Grip{0, nowhere}}}; }, "not a number"));
}

TEST_CASE("no simulation is made of nothing, of tools that are none or of joints at no cells") {
  CHECK(refuses([] { Simulation({}, {}); }, "at least one organ"));
  CHECK(refuses(
      [] {
        std::vector<std::unique_ptr<Tool>> tools(2);
        Simulation(makeOrgan(test::fullBlock(kSmallDims), {}), std::move(tools));
      },
      "tool 0 is null"));
  const auto withJoint = [](std::int32_t organ, std::int64_t cell, double stiffness) {
    std::vector<OperatedOrgan> organs;
    for (const char* name : {"a", "b"})
      organs.push_back(operatedOrgan(name, makeOrgan(test::fullBlock(kSmallDims), {})));
    TissueJoint joint;
    joint.organ = {0, organ};
    joint.cell = {0, cell};
    joint.stiffness = stiffness;
    Simulation(std::move(organs), {}, {joint});
  };
  withJoint(1, 0, 1);
  for (const std::int32_t organ : {-1, 2})
    CHECK(refuses([&] { withJoint(organ, 0, 1); }, "a joint is at organ"));
  for (const std::int64_t cell : {std::int64_t(-1), std::int64_t(kSmallDims.prod())})
    CHECK(refuses([&] { withJoint(1, cell, 1); }, "a joint is at cell"));
  for (const double wrong : {-1.0, kNaN, kEndless})
    CHECK(refuses([&] { withJoint(1, 0, wrong); }, "stiffness"));
  CHECK(refuses([] { stillTwoTools().surface(); }, "call keepLook() before"));
}

TEST_CASE(
    "whatever is put into a step, it is done or refused in a sentence, and the next is done") {
  Random random(11);
  const std::vector<double> odd = {0,    -0.0,  1e-300, 1e-9, 0.01,     1e3,
                                   1e30, 1e300, -1e300, kNaN, kEndless, -kEndless};
  const auto number = [&] {
    return random.uniform() < 0.7 ? random.uniform() * 0.06 - 0.01
                                  : odd[random.below(int(odd.size()))];
  };
  const auto place = [&] { return Vec3(number(), number(), number()); };
  const auto pose = [&] {
    Pose p{place(), Eigen::Quaterniond::Identity()};
    if (random.uniform() < 0.3) p.rotation.coeffs() << number(), number(), number(), number();
    return p;
  };
  const auto whole = [&](int most) {
    const double u = random.uniform();
    return u < 0.8   ? std::int64_t(random.below(most))
           : u < 0.9 ? -std::int64_t(random.below(3))
                     : std::int64_t(random.next() >> 2);
  };
  const int cells = kSmallDims.prod();
  const auto what = [&]() -> decltype(TissueEdit::what) {
    switch (random.below(7)) {
      case 0:
        return RemoveCell{whole(cells)};
      case 1:
        return SeverBond{whole(cells), std::int32_t(whole(26))};
      case 2: {
        Incision incision;
        const std::vector<Vec3> before = {place(), place()}, after = {place(), place()};
        incision.blade = ruledBlade(before, after);
        return incision;
      }
      case 3:
        return Grip{whole(cells), pose()};
      case 4:
        return Release{};
      case 5:
        return Carve{{place(), place(), number()}, number()};
      default:
        return SetLabel{whole(cells), std::uint8_t(random.below(256))};
    }
  };
  int done = 0, refused = 0;
  for (const bool moves : {false, true}) {
    Simulation simulation = moves ? elasticTwoTools() : stillTwoTools();
    const Bytes fresh = simulation.save();
    for (int i = 0; i < 400; ++i) {
      FrameInput input = inputFor(simulation);
      if (random.uniform() < 0.1) input.tools.resize(std::size_t(random.below(4)));
      if (random.uniform() < 0.2) input.duration = number();
      if (random.uniform() < 0.2) input.iso = float(number());
      for (ToolInput& tool : input.tools)
        tool = {pose(), random.uniform() < 0.8, number(), number()};
      for (int k = random.below(4); k > 0; --k)
        input.edits.push_back(
            {std::int32_t(random.uniform() < 0.9 ? 0 : whole(3)), std::int32_t(whole(2)), what()});
      const std::uint64_t before = simulation.stateHash();
      const std::string sentence = test::sentenceOf([&] { simulation.step(input); });
      (sentence.empty() ? done : refused) += 1;
      if (!sentence.empty()) {
        CHECK(test::isOneSentence(sentence));
        REQUIRE(simulation.stateHash() == before);
      }
      simulation.step(inputFor(simulation));
      if (i % 20 == 19) {
        simulation.restore(simulation.save());
        simulation.restore(fresh);
      }
    }
  }
  CHECK(done > 200);
  CHECK(refused > 100);
}
