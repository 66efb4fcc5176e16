// Is an argument that cannot be right refused in one sentence, and nothing done?
#include <doctest/doctest.h>

#include <limits>
#include <thread>

#include "operation/live/live_operation.h"
#include "operation/scenario.h"
#include "support/elastic_block.h"
#include "support/sentence.h"
#include "support/test_tools.h"

using namespace resect;
using test::refuses;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Is a scenario refused that differs from a right one by `change`?
template <typename Change>
bool scenarioRefused(Change change, const char* what) {
  Scenario scenario;
  scenario.organs[0].source.spacing = 0.01;
  scenario.tools.resize(1);
  scenario.tools[0].model = "baton";
  scenario.tools[0].keys = {{0, {}}, {1, {}}};
  requireSound(scenario);
  change(scenario);
  return refuses([&] { requireSound(scenario); }, what);
}

}  // namespace

TEST_CASE("a scenario with a value out of range or a name that is unknown is refused") {
  CHECK(scenarioRefused([](Scenario& s) { s.organs.clear(); }, "no organ"));
  for (const double wrong : {0.0, -60.0, kNaN, 1e9})
    CHECK(scenarioRefused([&](Scenario& s) { s.frameRate = wrong; }, "frames a second"));
  for (const double wrong : {0.0, -1.0, kNaN, 1e9})
    CHECK(scenarioRefused([&](Scenario& s) { s.duration = wrong; }, "lasts"));
  CHECK(scenarioRefused([](Scenario& s) { s.organs.resize(2); }, "two organs are named"));
  CHECK(scenarioRefused([](Scenario& s) { s.organs[0].source.beside = "spleen"; }, "\"spleen\""));
  CHECK(scenarioRefused([](Scenario& s) { s.organs[0].source.unit = 0; }, "units"));
  CHECK(scenarioRefused([](Scenario& s) { s.organs[0].source.pose.position.x() = kNaN; }, "pose"));
  CHECK(scenarioRefused(
      [](Scenario& s) {
        s.organs[0].source.labels.push_back({256, "", {}});
      },
      "256"));
  CHECK(scenarioRefused(
      [](Scenario& s) {
        s.organs[0].source.labels.push_back({1, "", {}});
      },
      "box"));
  CHECK(scenarioRefused(
      [](Scenario& s) {
        s.organs[0].tissue.materials.push_back({0, {}});
      },
      "label 0"));
  CHECK(scenarioRefused(
      [](Scenario& s) {
        TissueAttachment ball;
        ball.shape = Region::Shape::Ball;
        ball.radius = kNaN;
        s.organs[0].tissue.attachments.push_back(ball);
      },
      "radius"));
  CHECK(scenarioRefused(
      [](Scenario& s) {
        s.joints.push_back({{"organ", "organ"}});
      },
      "two organs"));
  CHECK(scenarioRefused(
      [](Scenario& s) {
        s.joints.push_back({{"organ", "spleen"}});
      },
      "\"spleen\""));
  CHECK(scenarioRefused([](Scenario& s) { s.tools[0].keys[1].time = 0; }, "each later"));
  CHECK(scenarioRefused([](Scenario& s) { s.tools[0].keys[0].time = kNaN; }, "each later"));
  CHECK(scenarioRefused([](Scenario& s) { s.tools[0].keys[0].squeeze = kNaN; }, "not a number"));
  CHECK(scenarioRefused([](Scenario& s) { s.tools[0].model.clear(); }, "no description"));
  CHECK(scenarioRefused([](Scenario& s) { s.tools[0].rest.position.x() = kNaN; }, "rests"));
}

TEST_CASE(
    "beyond a scenario's end its tools lie where they rest, and at no rate there are no frames") {
  Scenario scenario;
  scenario.tools.resize(1);
  scenario.tools[0].keys = {{0, {}}, {1, {}}};
  for (const std::int64_t frame : {std::int64_t(-1000), std::int64_t(1000), std::int64_t(1) << 60})
    CHECK(!frameInput(scenario, frame).tools[0].inHand);
  for (const double wrong : {0.0, -1.0, kNaN}) {
    scenario.frameRate = wrong;
    CHECK(refuses([&] { frameInput(scenario, 0); }, "frames a second"));
    CHECK(refuses([&] { frameCount(scenario); }, "frames a second"));
  }
  for (const double wrong : {0.0, -0.005, kNaN})
    CHECK(refuses([&] { setSpacing(scenario, 0.005, wrong); }, "lengths above 0"));
}

TEST_CASE("a live operation refuses tools that it does not have") {
  const auto simulation = [] {
    return std::make_unique<Simulation>(
        test::elasticBlock({3, 3, 3}, 0.008, test::ballTool(0.004)));
  };
  CHECK(refuses([&] { LiveOperation(simulation(), {}, 60); }, "0 places for 1 tools"));
  CHECK(refuses([&] { LiveOperation(simulation(), {Pose()}, 0); }, "give 1 to 1000"));
  LiveOperation operation(simulation(), {Pose()}, 60);
  for (const int wrong : {-1, 1}) CHECK(refuses([&] { operation.setTool(wrong, {}); }, "no tool"));
  operation.waitFor(1);
  FrameInput others;
  others.tools.resize(3);
  operation.play([=] { return others; });
  std::vector<SurfaceUpdate> updates;
  LiveState state;
  while (operation.playing()) std::this_thread::yield();
  operation.take(updates, state);
  const std::vector<std::string> said = state.faults;
  operation.waitFor(state.frame + 2);  // it goes on, and what was said is not lost on the way
  operation.take(updates, state);
  CHECK(said.size() + state.faults.size() == 1);
}

TEST_CASE("values that no tissue, organ or instrument reaches are refused") {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto tissue = [](auto change, const char* what) {
    return scenarioRefused([&](Scenario& s) { change(s.organs[0].tissue); }, what);
  };
  for (const double wrong : {1.0, 1e10, kNaN, kInfinity})
    CHECK(tissue([&](TissueSetup& t) { t.material.young = wrong; }, "give 10 to 1e+09 Pa"));
  for (const double wrong : {-0.1, 0.5, kNaN})
    CHECK(tissue([&](TissueSetup& t) { t.material.poisson = wrong; }, "poisson"));
  for (const double wrong : {1.0, 1e4, kNaN})
    CHECK(tissue([&](TissueSetup& t) { t.material.density = wrong; }, "give 100 to 5000 kg/m^3"));
  CHECK(tissue(
      [](TissueSetup& t) {
        t.materials.push_back({1, {}});
        t.materials[0].material.young = 1e9;
        t.materials[0].material.poisson = 0.4999;
      },
      "faster than the 5000 m/s of any tissue"));
  CHECK(tissue([](TissueSetup& t) { t.settings.gravity.y() = -1e3; }, "gravity"));
  CHECK(tissue([](TissueSetup& t) { t.settings.drag = -1; }, "drag"));
  for (const double wrong : {1e308, kInfinity, 1e-12})
    CHECK(scenarioRefused([&](Scenario& s) { s.organs[0].source.unit = wrong; }, "units"));
  for (const double wrong : {1e-6, 1.0, kNaN})
    CHECK(scenarioRefused([&](Scenario& s) { s.organs[0].source.spacing = wrong; }, "spacing"));
  CHECK(scenarioRefused([](Scenario& s) { s.organs[0].source.pose.position.x() = 101; }, "100 m"));
  CHECK(scenarioRefused([](Scenario& s) { s.tools[0].rest.position.y() = -1e5; }, "rests"));
  CHECK(scenarioRefused([](Scenario& s) { s.tools[0].keys[1].pose.position.z() = 1e5; }, "1 s"));
  CHECK(scenarioRefused([](Scenario& s) { s.tools[0].keys[1].time = 3601; }, "give 0 to 3600 s"));
}
