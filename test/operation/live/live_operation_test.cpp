#include "operation/live/live_operation.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "operation/live/hand_speed.h"
#include "support/block_organ.h"
#include "support/corners.h"
#include "support/elastic_block.h"
#include "support/test_tools.h"

using namespace resect;
using test::kAway;

namespace {

// An operation, and what a viewer would hold of it.
struct FollowedOperation {
  LiveOperation operation;
  SurfaceCopy held;
  LiveState state;

  explicit FollowedOperation(std::unique_ptr<Simulation> simulation)
      : operation(std::move(simulation), {kAway}, 240) {}

  void follow() {
    std::vector<SurfaceUpdate> updates;
    if (operation.take(updates, state)) apply(updates.at(0), held);
  }
  void frames(int count) {
    follow();
    operation.waitFor(state.frame + count);
    follow();
  }
};

// A block of 12 x 8 x 12 cells and one box-shaped tool, out of hand.
struct Live : FollowedOperation {
  Discretization cells = test::fullBlock({12, 8, 12});
  Aabb box = cells.lattice.box();

  Live() : FollowedOperation(simulation(test::fullBlock({12, 8, 12}))) {}
  static std::unique_ptr<Simulation> simulation(const Discretization& cells) {
    std::vector<std::unique_ptr<Tool>> tools;
    tools.push_back(test::boxTool({{-0.004, -0.004, 0}, {0.004, 0.004, 0.05}}));
    return std::make_unique<Simulation>(makeOrgan(cells, {}), std::move(tools));
  }
};

}  // namespace

TEST_CASE("a viewer that applies the changes holds the surface, however seldom it looks") {
  Live live;
  const Vec3 middle = live.box.centre();
  for (int i = 0; i < 12; ++i) {
    live.operation.setTool(0, {{middle + Vec3(0.004 * (i - 6), 0, 0), kAway.rotation}, true});
    live.frames(1 + i % 4);
  }
  live.frames(3);  // the last pose has had its effect
  CHECK(live.state.removed > 0);
  const auto whole = live.operation.surface();
  live.follow();
  const auto truth = test::sortedCorners(whole.mesh);
  CHECK(truth.size() > 100);
  CHECK(test::sortedCorners(live.held.points, live.held.triangles) == truth);
}

TEST_CASE(
    "the state tells the number of particles, what is under a tip in hand, and how fast it goes") {
  Live live;
  const Vec3 top(live.box.centre().x(), live.box.max.y(), live.box.centre().z());
  live.operation.setTool(0, {{top + Vec3(0, 0.012, 0), kAway.rotation}, true});
  live.frames(3);
  CHECK(live.state.particles == 12 * 8 * 12);
  CHECK(live.state.tips[0].below == doctest::Approx(top.y()).epsilon(0.05));
  CHECK(live.state.touching[0] == 0);
  CHECK(live.state.times.stages.size() == 11);
  CHECK(live.state.times.worst >= live.state.times.median);
  live.operation.setTool(0, {{live.box.centre(), kAway.rotation}, true});
  live.frames(3);
  CHECK(live.state.removed > 0);
  CHECK(live.state.particles == 12 * 8 * 12 - live.state.removed);
  CHECK(live.state.volume + live.state.removedVolume == doctest::Approx(live.cells.volume()));
  CHECK(live.state.touching[0] == 1);
  live.frames(40);  // at 240 a second: 0.1 s and more
  CHECK(live.state.touching[0] == 0);
}

TEST_CASE("jaws follow a hand as fast as it closes, and a motion at once") {
  Live live;
  ToolInput input{kAway, false, 1};
  live.operation.setTool(0, input);
  live.frames(2);
  REQUIRE(live.state.squeeze[0] == 1);
  input.squeeze = 0;
  live.operation.setTool(0, input);
  live.frames(5);
  CHECK(live.state.squeeze[0] > 0);
  live.frames(int(240 * kSqueezeTime) + 2);
  CHECK(live.state.squeeze[0] == 0);
  live.operation.play([input, frames = 3]() mutable -> std::optional<FrameInput> {
    input.squeeze = 1;
    if (frames-- == 0) return std::nullopt;
    return FrameInput{1.0 / 240, {input}, {}, {}, false};
  });
  std::vector<double> seen;
  for (int i = 0; i < 40; ++i) live.frames(1), seen.push_back(live.state.squeeze[0]);
  CHECK_FALSE(live.operation.playing());
  CHECK(live.state.played.empty());
  // Closed within a frame, then opened again by the hand's order, slowly.
  CHECK(*std::ranges::max_element(seen) > 0.9);
}

namespace {

// So slow that the operation is always late and never rests between frames.
class SlowPart : public WorkingPart {
 public:
  void act(const Touch&, std::vector<TissueEdit>&) const override {
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(5);
    while (std::chrono::steady_clock::now() < end) continue;
  }
};

}  // namespace

TEST_CASE("who wants the surface waits for the frame in work, however late the operation is") {
  std::vector<std::unique_ptr<Tool>> tools;
  tools.push_back(test::boxTool({{-0.004, -0.004, 0}, {0.004, 0.004, 0.05}}));
  tools.back()->parts.push_back(std::make_unique<SlowPart>());
  const Discretization cells = test::fullBlock({12, 8, 12});
  LiveOperation operation(std::make_unique<Simulation>(makeOrgan(cells, {}), std::move(tools)),
                          {kAway}, 1000);
  operation.setTool(0, {{cells.lattice.box().centre(), kAway.rotation}, true});
  operation.waitFor(5);
  std::vector<SurfaceUpdate> update;
  LiveState before, after;
  for (int i = 0; i < 20; ++i) {
    operation.take(update, before);
    CHECK(operation.surface().mesh.triangles.size() > 100);
    operation.take(update, after);
    CHECK(after.frame <= before.frame + 2);
    operation.waitFor(after.frame + 1);
  }
}

TEST_CASE("a tool out of hand touches nothing, and a paused operation stands still") {
  Live live;
  live.operation.setTool(0, {{live.box.centre(), kAway.rotation}, false});
  live.frames(3);
  CHECK(live.state.removed == 0);
  live.operation.setPaused(true);
  // The frame in work may still come.
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  live.follow();
  const auto frame = live.state.frame;
  std::vector<SurfaceUpdate> update;
  LiveState state;
  CHECK_FALSE(live.operation.take(update, state));
  live.operation.setPaused(false);
  live.operation.waitFor(frame + 1);
}

TEST_CASE("an operation that begins paused computes no frame before it goes on") {
  LiveOperation operation(Live::simulation(test::fullBlock({12, 8, 12})), {kAway}, 240, {}, {}, {},
                          true);
  std::vector<SurfaceUpdate> updates;
  LiveState state;
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  CHECK_FALSE(operation.take(updates, state));
  operation.setPaused(false);
  operation.waitFor(2);
  CHECK(operation.take(updates, state));
  CHECK(state.frame >= 2);
}

TEST_CASE("breathing is switched while an operation runs, and an earlier moment has its own") {
  auto simulation = std::make_unique<Simulation>(
      test::elasticBlock({6, 4, 6}, 0.008, test::boxTool({{-0.004, 0, 0}, {0.004, 0.004, 0.05}})));
  simulation->setBreathing({0.01, 60, 1, false});
  FollowedOperation live(std::move(simulation));
  live.frames(5);
  CHECK(live.state.canBreathe);
  CHECK(!live.state.breathes);
  const auto phase = [&] {
    double phase = 0;
    live.operation.look([&](const Simulation& now) { phase = now.breath().phase; });
    return phase;
  };
  CHECK(phase() == 0);
  live.operation.setBreathing(true);
  live.frames(10);
  CHECK(live.state.breathes);
  CHECK(phase() > 0);
  live.operation.setBreathing(false);
  live.frames(260);  // longer than a breath
  CHECK(!live.state.breathes);
  CHECK(phase() == 0);
  live.operation.show({0, 10});
  live.operation.waitForAnswer();
  live.follow();
  CHECK(live.state.breathes);
  live.operation.show({0, 2});
  live.operation.waitForAnswer();
  live.follow();
  CHECK(!live.state.breathes);
}
