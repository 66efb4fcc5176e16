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

TEST_CASE("a loop with no simulation ends at once when it is told to") {
  const HapticPlugin plugin(findHapticPlugin("simulated_hand"));
  const double began = steadySeconds();
  { const HapticLoop loop(hands(plugin, 1), 1, {}); }
  CHECK(steadySeconds() - began < 1);
}
