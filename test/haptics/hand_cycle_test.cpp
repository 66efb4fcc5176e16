// A simulated hand at simulated tissue, in simulated time: the force has no steps and no noise, and
// the hand gets no energy.
#include "haptics/hand_cycle.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "haptics/bench/force_noise.h"
#include "haptics/device/haptic_device.h"
#include "support/elastic_block.h"
#include "support/test_tools.h"

using namespace resect;

namespace {

constexpr double kSpacing = 0.006;
constexpr double kTop = 8 * kSpacing;  // of the block, m
constexpr double kRadius = 0.009;

struct Course {
  std::vector<HapticSample> samples;
  double largestStep = 0, peak = 0, most = 0, energy = 0, deepest = 0;
};

// The hand follows `path` (the ball's lowest point above the block) for some seconds. A frame's
// local model arrives `delay` s after the frame has begun.
Course course(const std::function<Vec3(double)>& path, double seconds, double delay,
              const char* options = "step=0.001") {
  Simulation simulation =
      test::elasticBlock({14, 8, 14}, kSpacing,
                         test::describedTool("baton", sphereMesh(Vec3(0, kRadius, 0), kRadius, 48),
                                             [](ToolModel&) {}));
  const HapticPlugin plugin(findHapticPlugin("simulated_hand"));
  HapticDevice device(plugin, options);
  const Vec3 middle(7 * kSpacing, kTop, 7 * kSpacing);
  const auto wanted = [&](double t) {
    return Pose{middle + path(t), Eigen::Quaterniond::Identity()};
  };
  device.intend(wanted(0));
  HandCycle cycle(device.mostForce(), device.read(), 0);
  LocalModels models;
  LocalModel model;
  FrameInput input;
  input.tools.resize(1);
  double nextFrame = 0, arrives = INFINITY;
  Course result;
  for (int i = 1; i <= int(seconds * 1000); ++i) {
    const double now = i * kHapticPeriod;
    device.intend(wanted(now));
    const Pose pose = device.read();
    if (now >= nextFrame) {
      input.tools[0].pose = pose;
      simulation.step(input);
      model = models.make(simulation, 0, input.duration);
      arrives = now + delay;
      nextFrame += input.duration;
    }
    const bool arrived = now >= arrives;
    if (arrived) arrives = INFINITY;
    const Wrench wrench = cycle.next(pose, arrived ? &model : nullptr, now);
    device.write(wrench);
    HapticSample sample;
    sample.time = float(now);
    sample.force = wrench.force.cast<float>();
    sample.still = (wanted(now).position - wanted(now - 0.1).position).norm() == 0;
    if (!result.samples.empty())
      result.largestStep =
          std::max(result.largestStep, double((sample.force - result.samples.back().force).norm()));
    result.samples.push_back(sample);
    result.peak = std::max(result.peak, wrench.force.norm());
    result.deepest = std::max(result.deepest, kTop - pose.position.y());
  }
  result.most = cycle.guard().mostEnergyToHand();
  result.energy = cycle.guard().energyToHand();
  return result;
}

double ramp(double t, double from, double to) {
  return std::clamp((t - from) / (to - from), 0.0, 1.0);
}

}  // namespace

TEST_CASE("a hand that presses, holds still and lets go feels a force without steps and noise") {
  for (const double delay : {0.004, 0.015}) {
    CAPTURE(delay);
    const Course c = course(
        [](double t) {
          return Vec3(0, 0.005 - 0.012 * (ramp(t, 0.1, 0.4) - ramp(t, 1.2, 1.5)), 0);
        },
        1.8, delay);
    const ForceNoise noise = forceNoise(c.samples);
    MESSAGE("peak " << c.peak << " N, " << 1e3 * c.deepest << " mm deep, step " << c.largestStep
                    << " N, noise " << 100 * noise.worst << " %, energy " << c.energy << " J");
    CHECK(c.peak > 0.5);
    CHECK(c.peak < 5);
    CHECK(c.deepest > 0.002);
    CHECK(c.largestStep < 0.08);
    CHECK(noise.windows >= 3);
    CHECK(noise.worst < 0.01);
    CHECK(c.energy < 0);
    CHECK(c.most <= 0);
    CHECK(c.samples.back().force.norm() < 0.02f);
  }
}

TEST_CASE("a hand that is shaken fast in contact gets no energy") {
  for (const double rate : {5.0, 12.0, 25.0})
    for (const char* options : {"step=0.001", "step=0.001,resolution=2e-5,mass=0.05,damping=2"}) {
      CAPTURE(rate);
      CAPTURE(options);
      const Course c = course(
          [&](double t) {
            const double turn = 2 * std::numbers::pi * rate * t;
            return Vec3(0.003 * std::sin(0.7 * turn), -0.002 - 0.006 * std::sin(turn), 0);
          },
          1.5, 0.012, options);
      MESSAGE("peak " << c.peak << " N, energy " << c.energy << " J, at most " << c.most << " J");
      CHECK(c.peak > 0.1);
      CHECK(c.energy < 0);
      CHECK(c.most <= 1e-6);
    }
}

TEST_CASE("the brake keeps to the force that the device renders") {
  PassivityGuard guard(3);
  Pose pose;
  guard.moved(pose);
  // The hand stands still, then runs with the force at 2 m/s: nobody could foresee that.
  double most = 0;
  bool brakes = false;
  for (int i = 0; i < 60; ++i) {
    if (i > 50) pose.position.x() += 2e-3;
    guard.moved(pose);
    const Wrench wrench = guard.allow({Vec3(3, 0, 0), Vec3::Zero()}, 1e-3);
    most = std::max(most, wrench.force.norm());
    brakes = brakes || wrench.force.x() < -1;
  }
  CHECK(brakes);
  CHECK(most <= 3 + 1e-12);
}

TEST_CASE("planes push and never pull, and friction keeps to its limit") {
  LocalModel model;
  model.inHand = true;
  model.duration = 1.0 / 60;
  model.planeCount = 1;
  model.planes[0] = {Vec3::Zero(), Vec3::UnitY(), 1, 200, 0};
  model.rest = Vec3(0.1, 0, 0);
  model.restStiffness = 100;
  model.friction = 0.3;
  HandState hand;
  CHECK((forceAt(model, hand).force - Vec3(0.1, 1, 0)).norm() < 1e-12);
  hand.pose.position = Vec3(0, -0.001, 0);
  CHECK(forceAt(model, hand).force.y() == doctest::Approx(1.2));
  hand.pose.position = Vec3(-0.1, 0, 0);  // 10 N of stiffness, but it slides
  CHECK(forceAt(model, hand).force.x() == doctest::Approx(0.3));
  hand.pose.position = Vec3(0, 0.0051, 0);
  CHECK(forceAt(model, hand).force.norm() == 0);
  model.held = true;  // a grip pulls back
  CHECK(forceAt(model, hand).force.y() == doctest::Approx(-0.51));
  model.inHand = false;
  CHECK(forceAt(model, hand).force.norm() == 0);
}

TEST_CASE("a new model changes the force by nothing at once, and wholly after a frame") {
  LocalModel weak, strong;
  weak.inHand = strong.inHand = true;
  weak.duration = strong.duration = 0.02;
  weak.rest = Vec3(1, 0, 0);
  strong.rest = Vec3(2, 0, 0);
  ForceRenderer renderer;
  const HandState hand;
  for (const double arrival : {1.0, 1.1, 1.12}) renderer.take(weak, hand, arrival);
  renderer.take(strong, hand, 1.14);
  CHECK(renderer.render(hand, 1.14).force.x() == doctest::Approx(1));
  CHECK(renderer.render(hand, 1.15).force.x() == doctest::Approx(1.5));
  CHECK(renderer.render(hand, 1.16).force.x() == doctest::Approx(2));
  CHECK(renderer.correction() == doctest::Approx(1));
  CHECK_THROWS_AS(ForceRenderer(0), Error);
}
