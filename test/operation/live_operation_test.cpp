#include "operation/live_operation.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <thread>

#include "support/block_organ.h"
#include "support/elastic_block.h"
#include "support/test_tools.h"

using namespace resect;

namespace {

const Pose kAway{Vec3(0, 1, 0), Eigen::Quaterniond::Identity()};

// An operation, and what a viewer would hold of it.
struct Followed {
  LiveOperation operation;
  std::vector<Vec3f> points;
  std::vector<Triangle> triangles;
  LiveState state;
  std::size_t sent = 0;  // vertices

  explicit Followed(std::unique_ptr<Simulation> simulation)
      : operation(std::move(simulation), {kAway}, 240) {}

  void follow() {
    SurfaceUpdate update;
    if (!operation.take(update, state)) return;
    if (update.everything) points.clear(), triangles.clear();
    for (const auto& range : update.vertices) {
      sent += range.points.size();
      points.resize(std::max(points.size(), std::size_t(range.first) + range.points.size()));
      std::copy(range.points.begin(), range.points.end(), points.begin() + range.first);
    }
    for (const auto& range : update.triangles) {
      triangles.resize(
          std::max(triangles.size(), std::size_t(range.first) + range.triangles.size()));
      std::copy(range.triangles.begin(), range.triangles.end(), triangles.begin() + range.first);
    }
  }
  void frames(int count) {
    follow();
    operation.waitFor(state.frame + count);
    follow();
  }
};

// A block of 12 x 8 x 12 cells and one box-shaped tool, out of hand.
struct Live : Followed {
  Aabb box = test::fullBlock({12, 8, 12}).lattice.box();

  Live() : Followed(simulation(test::fullBlock({12, 8, 12}))) {}
  static std::unique_ptr<Simulation> simulation(const Discretization& cells) {
    std::vector<std::unique_ptr<Tool>> tools;
    tools.push_back(test::boxTool({{-0.004, -0.004, 0}, {0.004, 0.004, 0.05}}));
    return std::make_unique<Simulation>(makeOrgan(cells, {}), std::move(tools));
  }
};

// Triangles with their corners.
std::vector<std::array<float, 9>> corners(const std::vector<Vec3f>& points,
                                          const std::vector<Triangle>& triangles) {
  std::vector<std::array<float, 9>> result;
  for (const Triangle& t : triangles)
    if (t[0] != t[1]) {
      auto& triangle = result.emplace_back();
      for (int c = 0; c < 3; ++c)
        std::copy_n(points[std::size_t(t[c])].data(), 3, triangle.begin() + 3 * c);
    }
  return result;
}

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
  std::vector<Vec3f> points;
  for (const Vec3& p : whole.mesh.points) points.push_back(p.cast<float>());
  live.follow();
  auto held = corners(live.points, live.triangles), truth = corners(points, whole.mesh.triangles);
  std::ranges::sort(held), std::ranges::sort(truth);
  CHECK(held.size() == truth.size());
  CHECK(held == truth);
}

TEST_CASE("of tissue that moves a viewer is told what can be seen to move, and holds the surface") {
  Followed live(std::make_unique<Simulation>(test::elasticBlock(
      {7, 4, 7}, 0.01, test::boxTool({{-0.004, -0.004, 0}, {0.004, 0.004, 0.05}}, "baton", ""))));
  const auto off = [&] {  // m, at most
    const auto whole = live.operation.surface();
    live.follow();
    const auto held = corners(live.points, live.triangles);
    std::vector<Vec3f> points;
    for (const Vec3& p : whole.mesh.points) points.push_back(p.cast<float>());
    const auto truth = corners(points, whole.mesh.triangles);
    REQUIRE(held.size() == truth.size());
    float most = 0;
    for (std::size_t t = 0; t < held.size(); ++t)
      for (std::size_t i = 0; i < 9; ++i) most = std::max(most, std::abs(held[t][i] - truth[t][i]));
    return most;
  };
  const auto press = [&](double depth) {
    live.operation.setTool(0, {{Vec3(0.035, 0.04 - depth, 0.035),
                                Eigen::Quaterniond(Eigen::AngleAxisd(-M_PI / 2, Vec3::UnitX()))},
                               true});
  };
  live.operation.waitFor(360);
  for (int i = 0; i < 8; ++i) {
    press(0.001 * i);
    live.frames(1 + i % 4);
  }
  live.frames(240);  // at rest, pressed
  live.sent = 0;
  live.frames(60);
  CHECK(live.sent < live.points.size() / 4);
  live.operation.setPaused(true);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  CHECK(off() < 1e-4);
  live.operation.setPaused(false);
  press(0.004);
  live.frames(20);
  CHECK(live.sent > live.points.size() / 4);
}

TEST_CASE("the tip knows what lies under it and how near tissue is") {
  Live live;
  const Vec3 top(live.box.centre().x(), live.box.max.y(), live.box.centre().z());
  const auto placeAt = [&](const Vec3& tip) {
    live.operation.setTool(0, {{tip, kAway.rotation}, true});
    live.frames(2);
    return live.state.tips[0];
  };
  const TipPlace above = placeAt(top + Vec3(0, 0.012, 0));
  CHECK(above.below == doctest::Approx(top.y()).epsilon(0.05));
  CHECK(above.distance == doctest::Approx(0.012).epsilon(0.1));
  const TipPlace beside = placeAt(Vec3(live.box.max.x() + 0.2, top.y(), top.z()));
  CHECK(beside.below == 0);
  CHECK(beside.distance == doctest::Approx(kTipReach));
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
  SurfaceUpdate update;
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
  SurfaceUpdate update;
  LiveState state;
  CHECK_FALSE(live.operation.take(update, state));
  live.operation.setPaused(false);
  live.operation.waitFor(frame + 1);
}
