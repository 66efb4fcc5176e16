#include "operation/live/surface_publisher.h"

#include <doctest/doctest.h>

#include "support/block_organ.h"
#include "support/corners.h"
#include "support/elastic_block.h"
#include "support/test_tools.h"

using namespace resect;
using test::kAway, test::kUnturned;

namespace {

// A simulation with one tool, its publisher, and what a viewer holds of it.
struct FollowedSurface {
  Simulation simulation;
  SurfacePublisher publisher;
  SurfaceCopy held;
  std::size_t moved = 0, made = 0, wholes = 0;  // vertices and updates that were taken

  explicit FollowedSurface(Simulation s, float seenMotion = SurfacePublisher::kSeenMotion)
      : simulation(std::move(s)), publisher(seenMotion) {
    simulation.keepLook();
  }
  void step(const Pose& pose, bool inHand = true, std::optional<float> iso = {}) {
    FrameInput input;
    input.tools = {{pose, inHand}};
    input.iso = iso;
    simulation.step(input);
    publisher.follow(presentSurface(simulation));
  }
  void take() {
    const SurfaceUpdate update = publisher.take();
    moved += update.points.size();
    made += update.rest.size();
    wholes += update.everything;
    apply(update, held);
  }
  std::size_t vertices() const { return simulation.surfacePoints().size(); }
  // m: how far a vertex that a triangle uses is from where it is held, at most.
  float off() const {
    const auto truth =
        test::corners(simulation.surfacePoints(), simulation.organ().surface.triangles());
    const auto copy = test::corners(held.points, held.triangles);
    REQUIRE(copy.size() == truth.size());
    float most = 0;
    for (std::size_t t = 0; t < truth.size(); ++t)
      for (std::size_t i = 0; i < 9; ++i) most = std::max(most, std::abs(copy[t][i] - truth[t][i]));
    return most;
  }
  // Are rest places and shares of cut those of the tracker wherever a triangle is?
  bool sameAtRest() const {
    const SurfaceTracker& surface = simulation.organ().surface;
    for (const Triangle& t : surface.triangles())
      for (const std::int32_t v : t)
        if (t[0] != t[1] && (held.rest[std::size_t(v)] != surface.points()[std::size_t(v)] ||
                             held.cut[std::size_t(v)] != surface.cut()[std::size_t(v)]))
          return false;
    return true;
  }
};

FollowedSurface followedStill() {
  std::vector<std::unique_ptr<Tool>> tools;
  tools.push_back(test::boxTool({{-0.004, -0.004, 0}, {0.004, 0.004, 0.05}}));
  return FollowedSurface(Simulation(makeOrgan(test::fullBlock({12, 8, 12}), {}), std::move(tools)));
}

FollowedSurface followedElastic(float seenMotion = SurfacePublisher::kSeenMotion) {
  return FollowedSurface(
      test::elasticBlock({7, 4, 7}, 0.01,
                         test::boxTool({{-0.004, -0.004, 0}, {0.004, 0.004, 0.05}}, "baton", "")),
      seenMotion);
}

// Presses a baton this deep into the block's top, m.
Pose pressedBy(double depth) {
  return {Vec3(0.035, 0.04 - depth, 0.035),
          Eigen::Quaterniond(Eigen::AngleAxisd(-M_PI / 2, Vec3::UnitX()))};
}

}  // namespace

TEST_CASE("a viewer that applies the updates holds the surface, however seldom it takes them") {
  FollowedSurface live = followedStill();
  const Vec3 middle = live.simulation.organ().rest.lattice.box().centre();
  for (int i = 0; i < 24; ++i) {
    live.step({middle + Vec3(0.002 * (i - 12), 0, 0), kUnturned});
    if (i % (1 + i % 4) == 0) live.take();
  }
  live.take();
  CHECK(live.simulation.organ().removed > 0);
  CHECK(live.wholes == 1);  // the first
  CHECK(live.off() == 0);
  CHECK(live.sameAtRest());
  live.step(kAway, false);
  CHECK(live.publisher.take().empty());  // nothing happened
}

TEST_CASE("another iso level, and a viewer that is long away, get the whole once") {
  FollowedSurface live = followedStill();
  const Vec3 middle = live.simulation.organ().rest.lattice.box().centre();
  live.step(kAway, false);
  live.take();
  live.step(kAway, false, 60.0f);
  live.take();
  CHECK(live.wholes == 2);
  CHECK(live.off() == 0);

  live.made = 0;
  for (int i = 0; i < 200; ++i)
    live.step({middle + Vec3(0.02 * std::sin(0.9 * i), 0, 0.02 * std::sin(0.37 * i)), kUnturned});
  live.take();
  CHECK(live.wholes == 3);
  CHECK(live.made <= 3 * live.vertices());
  CHECK(live.off() == 0);
}

TEST_CASE("of tissue that moves a viewer is told what can be seen to move, without rest and cut") {
  FollowedSurface live = followedElastic();
  for (int i = 0; i < 300; ++i) live.step(kAway, false);
  for (int i = 0; i < 16; ++i) {
    live.step(pressedBy(0.0005 * i));
    if (i % 3 == 0) live.take();
    CHECK((i % 3 || live.off() < 2 * SurfacePublisher::kSeenMotion));
  }
  CHECK(live.wholes == 1);
  CHECK(live.made == live.vertices());  // in the first
  CHECK(live.sameAtRest());

  for (int i = 0; i < 300; ++i) live.step(pressedBy(0.008));  // comes to rest, pressed
  live.take();
  live.moved = 0;
  for (int i = 0; i < 60; ++i) live.step(pressedBy(0.008)), live.take();
  CHECK(live.moved < live.vertices() / 4);
  CHECK(live.off() < 2 * SurfacePublisher::kSeenMotion);
  for (int i = 0; i < 5; ++i) live.step(pressedBy(0.004)), live.take();
  CHECK(live.moved > live.vertices() / 4);
  CHECK(live.made == live.vertices());
}

TEST_CASE("a publisher that passes no motion over gives the surface as it is") {
  FollowedSurface live = followedElastic(0);
  for (int i = 0; i < 30; ++i) {
    live.step(pressedBy(0.0005 * i));
    live.take();
    CHECK(live.off() == 0);
  }
  CHECK(live.moved > live.vertices());
}

TEST_CASE("new vertices of tissue that moves come with rest place, cut, point and normal") {
  ToolModel model;
  model.name = model.kind = "scalpel";
  model.response = "remove";
  model.mesh = boxMesh({{-0.004, -0.004, 0}, {0.004, 0.004, 0.05}});
  FollowedSurface live(test::elasticBlock({7, 4, 7}, 0.01, makeTool(std::move(model))));
  for (int i = 0; i < 120; ++i) live.step(kAway, false);
  live.take();
  const std::size_t whole = live.made;
  const auto trianglesHeld = [&] {
    return test::corners(live.held.points, live.held.triangles).size();
  };
  const std::size_t before = trianglesHeld();
  for (int i = 0; i < 40; ++i) {
    live.step({Vec3(0.035, 0.045 - 0.001 * i, 0.035), kUnturned});
    if (i % 4 == 3) live.take();
  }
  live.take();
  CHECK(live.wholes == 1);
  CHECK(live.made > whole);
  CHECK(trianglesHeld() != before);
  CHECK(live.off() < 2 * SurfacePublisher::kSeenMotion);
  CHECK(live.sameAtRest());
}

TEST_CASE("after a restore and steps that were not followed the viewer gets the whole surface") {
  for (const bool elastic : {false, true}) {
    CAPTURE(elastic);
    FollowedSurface live = elastic ? followedElastic() : followedStill();
    const Vec3 middle = live.simulation.organ().rest.lattice.box().centre();
    const auto pose = [&](int i) {
      return elastic ? pressedBy(0.0005 * i)
                     : Pose{middle + Vec3(0.002 * (i - 6), 0, 0), kUnturned};
    };
    Bytes kept;
    for (int i = 0; i < 12; ++i) {
      if (i == 4) kept = live.simulation.save();
      live.step(pose(i));
      live.take();
    }
    live.simulation.restore(kept);
    FrameInput input;
    input.tools = {{pose(4)}};
    live.simulation.step(input);
    live.simulation.step(input);
    live.publisher.follow(presentSurface(live.simulation));
    live.take();
    CHECK(live.off() < 1e-4f);
    CHECK(live.sameAtRest());
    live.step(pose(7));
    live.take();
    CHECK(live.off() < 1e-4f);
  }
}
