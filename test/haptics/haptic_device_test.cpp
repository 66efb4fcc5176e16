// Plug-ins of haptic devices: what is wrong with one is said in a sentence.
#include "haptics/device/haptic_device.h"

#include <doctest/doctest.h>

#include <fstream>

#include "support/sentence.h"
#include "support/temporary_folder.h"

using namespace resect;

TEST_CASE("the simulated hand goes where the person wants, and gives way to a force") {
  const HapticPlugin plugin(findHapticPlugin("simulated_hand"));
  CHECK(plugin.name() == "simulated hand");
  HapticDevice device(plugin, "step=0.001,stiffness=500");
  CHECK(device.plays());
  CHECK(device.mostForce() > 1);
  const Pose wanted{{0.1, 0.2, 0.3}, Eigen::Quaterniond::Identity()};
  device.intend(wanted);
  CHECK((device.read().position - wanted.position).norm() < 1e-12);
  device.write({Vec3(0, 2, 0), Vec3::Zero()});
  Pose pose;
  for (int i = 0; i < 1000; ++i) pose = device.read();
  CHECK((pose.position - wanted.position - Vec3(0, 2.0 / 500, 0)).norm() < 1e-6);
}

TEST_CASE("what is wrong with a plug-in is said in one sentence") {
  const test::TemporaryFolder folder;
  folder.write("text.so", "this is no library");
  const auto opens = [&](const char* name) {
    return [&folder, name] { HapticPlugin(folder / name); };
  };
  CHECK(test::refuses(opens("none.so"), "there is no haptic plug-in"));
  CHECK(test::refuses(opens("text.so"), "is not a shared library"));
  CHECK(test::refuses([] { findHapticPlugin("no_such_device"); }, "no_such_device"));
  const HapticPlugin plugin(findHapticPlugin("simulated_hand"));
  CHECK(test::refuses([&] { HapticDevice(plugin, "mass=none"); }, "mass=none"));
  CHECK(test::refuses([&] { HapticDevice(plugin, "colour=3"); }, "is no option"));
}
