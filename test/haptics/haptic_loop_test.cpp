// The loop on a thread of its own: it gives poses, takes models, keeps its pace and ends.
#include "haptics/loop/haptic_loop.h"

#include <doctest/doctest.h>

#include "base/stage_clock.h"

using namespace resect;

namespace {

std::vector<std::unique_ptr<HapticDevice>> hands(const HapticPlugin& plugin, int count) {
  std::vector<std::unique_ptr<HapticDevice>> devices;
  for (int k = 0; k < count; ++k)
    devices.push_back(std::make_unique<HapticDevice>(plugin, "stiffness=500"));
  return devices;
}

}  // namespace

TEST_CASE("the loop renders the newest model of each hand while the simulation takes its time") {
  const HapticPlugin plugin(findHapticPlugin("simulated_hand"));
  HapticLoop loop(hands(plugin, 2), 0.5, [](std::size_t hand, double) {
    return HandIntent{{Vec3(0.1 * double(hand), 0, 0), Eigen::Quaterniond::Identity()}, true};
  });
  CHECK(loop.hands() == 2);
  CHECK(loop.pose(1).position.x() == doctest::Approx(0.1));
  // A constant force upwards on the second hand; the simulation is at no more than 20 frames a
  // second.
  LocalModel model;
  model.inHand = true;
  model.duration = 1.0 / 60;
  model.rest = Vec3(0, 1, 0);
  for (int frame = 0; frame < 8; ++frame) {
    loop.check();
    model.pose = loop.pose(1);
    loop.give(1, model);
    sleepUntil(steadySeconds() + 0.05);
  }
  loop.stop();
  CHECK(loop.times().cycles > 300);
  CHECK(loop.times().missed < loop.times().cycles / 2);  // others use the machine too
  CHECK(loop.samples(0).size() == loop.samples(1).size());
  CHECK(loop.samples(0).back().force.norm() == 0);
  // Tissue that pushes a hand which has given nothing does not drive it: the guard holds back.
  CHECK(loop.guard(1).mostEnergyToHand() <= 1e-6);
  CHECK(loop.guard(1).interventions() > 0);
  CHECK(loop.pose(1).position.y() < 1e-4);
}

namespace {

// A plug-in whose first device fails after some reads; the second one remembers its force.
struct Failing {
  int reads = 0;
  double force = -1;
};
Failing failing[2];
int opened = 0;

Failing& at(ResectHapticDevice* device) { return *reinterpret_cast<Failing*>(device); }

constexpr ResectHapticDeviceFunctions kFailing = {
    RESECT_HAPTIC_DEVICE_VERSION,
    "failing",
    [](const char*, ResectHapticLimits* limits) {
      limits->most_force = 5;
      return reinterpret_cast<ResectHapticDevice*>(&failing[opened++]);
    },
    [](ResectHapticDevice*) {},
    [](ResectHapticDevice* device, ResectHapticPose*) {
      return int(&at(device) == &failing[0] && ++at(device).reads > 50);
    },
    [](ResectHapticDevice* device, const ResectHapticForce* force) {
      at(device).force = std::abs(force->force[1]);
      return 0;
    },
    [](ResectHapticDevice*) { return "the cable is out"; },
    nullptr};

}  // namespace

TEST_CASE("when a device fails the others get no force any more, and the reason is told") {
  std::vector<std::unique_ptr<HapticDevice>> devices;
  for (int k = 0; k < 2; ++k)
    devices.push_back(std::make_unique<HapticDevice>(kFailing, "failing", ""));
  HapticLoop loop(std::move(devices), 1, {});
  LocalModel model;
  model.inHand = true;
  model.duration = 1.0 / 60;
  model.planeCount = 1;
  model.planes[0] = {Vec3::Zero(), Vec3::UnitY(), 1, 200, 0};
  loop.give(1, model);
  sleepUntil(steadySeconds() + 0.3);
  CHECK(failing[0].reads == 51);
  CHECK(failing[1].force == 0);
  CHECK_THROWS_WITH_AS(loop.stop(), doctest::Contains("the cable is out"), Error);
}

TEST_CASE("a loop with no simulation ends at once when it is told to") {
  const HapticPlugin plugin(findHapticPlugin("simulated_hand"));
  const double began = steadySeconds();
  { const HapticLoop loop(hands(plugin, 1), 1, {}); }
  CHECK(steadySeconds() - began < 1);
}
