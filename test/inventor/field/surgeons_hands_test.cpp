// The gloved hands that hold the instruments: which hand, where on the handle, and when it is seen.
#include "inventor/scene/surgeons_hands.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "base/random.h"
#include "geometry/rotation.h"
#include "inventor/picture/offscreen_view.h"
#include "inventor/reading/model_file.h"
#include "inventor/scene/operation_view.h"
#include "io/data_folder.h"
#include "io/operation_setup.h"

using namespace resect;

namespace {

// All instruments in the operative field, at rest.
struct HandBench {
  Scenario scenario;
  std::unique_ptr<Simulation> simulation;
  std::unique_ptr<OperationView> view;
  OffscreenView screen{320, 200, 1};

  explicit HandBench(const std::string& from = "surgeon") {
    scenario.organs[0].source.spacing = 0.015;
    for (const std::string& name : shippedNames("tools", ".toml")) {
      const Vec3 away(0.02 * double(scenario.tools.size()), 1, 0);
      scenario.tools.push_back({name, {}, {away, Eigen::Quaterniond::Identity()}, {}});
    }
    scenario.setting = "field";
    scenario.view = from;
    simulation = std::make_unique<Simulation>(makeSimulation(scenario, &readModel));
    view = std::make_unique<OperationView>(scenario, *simulation, 1.6);
  }
  OperatingRoom& room() { return view->room(); }
  const ToolModel& model(std::size_t tool) const { return simulation->tools()[tool].tool->model; }
  // Pixels in which the hands are seen.
  int handPixels() {
    RgbImage pictures[2];
    for (const bool hands : {false, true}) {
      room().showHands(hands);
      room().changedIn({});
      pictures[hands] = view->draw(screen);
    }
    int pixels = 0;
    for (std::size_t i = 0; i < pictures[0].pixels.size(); i += 3)
      pixels +=
          !std::equal(&pictures[0].pixels[i], &pictures[0].pixels[i] + 3, &pictures[1].pixels[i]);
    return pixels;
  }
  // The organ's middle, on its upper side.
  Vec3 over() const {
    const Aabb box = simulation->organ().rest.lattice.box();
    return {box.centre().x(), box.max.y(), box.centre().z()};
  }
};

// A pose with the tip at `tip` and the handle towards `handle`.
Pose held(const Vec3& tip, const Vec3& handle) {
  return {tip, Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), handle)};
}

}  // namespace

TEST_CASE("every instrument has a hand that holds its handle") {
  const HandBench bench;
  for (std::size_t i = 0; i < bench.scenario.tools.size(); ++i) {
    const ToolModel& tool = bench.model(i);
    CAPTURE(tool.kind);
    const std::optional<HandGrip> grip = gripOf(tool);
    REQUIRE(grip);
    // The hand's origin is in the middle between the handle's sides, or between its rings.
    Aabb handle;
    for (const Triangle& t : tool.mesh.triangles) {
      Aabb box;
      for (const auto corner : t) box.grow(tool.mesh.points[std::size_t(corner)]);
      if (box.min.z() > grip->at.z() || box.max.z() < grip->at.z()) continue;
      handle.grow(box.min), handle.grow(box.max);
    }
    REQUIRE_FALSE(handle.empty());
    const Vec3 off = grip->at - handle.centre();
    CHECK(Vec3(off.x(), off.y(), 0).norm() < 0.004);
  }
}

TEST_CASE("an instrument of another kind or with a short handle is held by no hand") {
  const HandBench bench;
  ToolModel tool = bench.model(0);
  tool.kind = "trowel";
  CHECK_FALSE(gripOf(tool));
  tool = bench.model(0);
  for (Vec3& p : tool.mesh.points) p.z() *= 0.3;
  CHECK_FALSE(gripOf(tool));
}

TEST_CASE("the forearm comes from the surgeon, however the instrument is held") {
  Random random(7);
  const auto any = [&] {
    return Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  };
  for (const bool left : {false, true})
    for (const bool turns : {false, true})
      for (int k = 0; k < 50; ++k) {
        const HandGrip grip{"hand_pen", {0, 0.003, 0.08}, left, turns};
        const Pose tool{0.2 * any(),
                        rotationAbout(any().normalized(), random.uniform(-3, 3)).normalized()};
        const Pose hand = handPose(grip, tool);
        CHECK((hand.position - tool * grip.at).norm() < 1e-12);
        const Vec3 handle = tool.rotation * Vec3::UnitZ();
        CHECK((hand.rotation * Vec3::UnitZ() - handle).norm() < 1e-9);
        const Vec3 forearm = hand.rotation * Vec3::UnitX(), side = hand.rotation * Vec3::UnitY();
        const Vec3 elbow = Vec3(left ? -0.28 : 0.28, 0.20, 0.50) - hand.position;
        CHECK(forearm.dot(elbow) >= 0);
        if (turns) {
          CHECK(std::abs(side.dot(elbow)) < 1e-9);
        } else {
          CHECK(std::abs(forearm.dot(tool.rotation * Vec3::UnitX())) == doctest::Approx(1));
        }
      }
}

TEST_CASE("hands are seen in the field with instruments in use, and never between eye and tip") {
  HandBench bench;
  bench.view->showField(false);
  CHECK(bench.handPixels() == 0);
  bench.view->showField(true);
  CHECK(bench.handPixels() == 0);  // all instruments are at rest
  const Vec3 towards = towardsCamera(RoomView::Surgeon), over = bench.over();
  for (std::size_t i = 0; i < bench.scenario.tools.size(); ++i) {
    CAPTURE(bench.model(i).kind);
    const int tool = int(i);
    bench.room().setToolPose(tool, held(over, Vec3(0.9, 0.5, -0.3).normalized()));
    CHECK(bench.handPixels() > 150);
    const Aabb bounds = bench.room().handBounds(tool);
    REQUIRE_FALSE(bounds.empty());
    CHECK(bounds.size().maxCoeff() > 0.2);
    // The handle points to the eye.
    bench.room().setToolPose(tool, held(over, towards));
    CHECK(bench.handPixels() == 0);
    bench.room().setToolPose(tool, bench.scenario.tools[i].rest);
    CHECK(bench.handPixels() == 0);
    CHECK(bench.room().handBounds(tool).empty());
  }
}

TEST_CASE("a laparoscope sees no hands") {
  HandBench bench("laparoscope");
  bench.room().setToolPose(0, held(bench.over(), Vec3(0.9, 0.5, -0.3).normalized()));
  CHECK(bench.handPixels() == 0);
}
