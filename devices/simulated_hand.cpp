// A haptic device that is simulated, hand included: the plug-in with which Resect measures the
// force for a hand where there is no device.
//
// A mass, the device's and the hand's together, is drawn by a damped spring to where the person
// wants it (intend()), and pushed by the force that Resect writes. It moves in real time. Options,
// separated by commas:
//
//     mass=0.15        kg
//     stiffness=400    of the hand's grip, N/m
//     damping=10       of the hand's grip, N s/m
//     resolution=0     of the position that is read, m; encoders have some 1e-5
//     step=0           s by which each read() advances time; 0: real time
#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <new>
#include <string>

#include "haptics/device/resect_haptic_device.h"

namespace {

constexpr double kLongest =
    0.05;  // s: the longest time that a read() advances; longer pauses are skipped
constexpr double kSubstep = 1e-4;  // s

struct SimulatedHand {
  double mass = 0.15, stiffness = 400, damping = 10, resolution = 0, step = 0;
  double at[3] = {}, speed[3] = {}, force[3] = {};
  ResectHapticPose wanted{{0, 0, 0}, {0, 0, 0, 1}, 0};
  bool placed = false;
  double last = 0;  // time of the last read(), s
};

thread_local std::string lastError;

double now() {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

SimulatedHand& handOf(ResectHapticDevice* device) {
  return *reinterpret_cast<SimulatedHand*>(device);
}

// Sets one option "name=value"; false if it is none.
bool set(SimulatedHand& hand, const std::string& option) {
  const std::size_t equals = option.find('=');
  if (equals == std::string::npos) return false;
  const std::string name = option.substr(0, equals), text = option.substr(equals + 1);
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value) || value < 0) return false;
  double* target = name == "mass"         ? &hand.mass
                   : name == "stiffness"  ? &hand.stiffness
                   : name == "damping"    ? &hand.damping
                   : name == "resolution" ? &hand.resolution
                   : name == "step"       ? &hand.step
                                          : nullptr;
  if (!target || (target == &hand.mass && value <= 0)) return false;
  *target = value;
  return true;
}

ResectHapticDevice* openHand(const char* options, ResectHapticLimits* limits) {
  auto* hand = new (std::nothrow) SimulatedHand;
  if (!hand) {
    lastError = "out of memory";
    return nullptr;
  }
  const std::string all = options;
  for (std::size_t begin = 0; begin < all.size();) {
    const std::size_t end = std::min(all.find(',', begin), all.size());
    const std::string one = all.substr(begin, end - begin);
    if (!set(*hand, one)) {
      lastError = "\"" + one +
                  "\" is no option, or its value cannot be used; give mass (above 0), stiffness, "
                  "damping, resolution or step, each with = and a number from 0";
      delete hand;
      return nullptr;
    }
    begin = end + 1;
  }
  limits->most_force = 20;
  limits->most_torque = 0.5;
  hand->last = now();
  return reinterpret_cast<ResectHapticDevice*>(hand);
}

void closeHand(ResectHapticDevice* device) { delete &handOf(device); }

// Moves the hand by dt: symplectic Euler, with a substep far below the grip's own time.
void advance(SimulatedHand& hand, double dt) {
  const int count = std::max(1, int(std::ceil(dt / kSubstep)));
  const double h = dt / count;
  for (int i = 0; i < count; ++i)
    for (int a = 0; a < 3; ++a) {
      const double pull = hand.stiffness * (hand.wanted.position[a] - hand.at[a]) -
                          hand.damping * hand.speed[a] + hand.force[a];
      hand.speed[a] += h * pull / hand.mass;
      hand.at[a] += h * hand.speed[a];
    }
}

void intendHand(ResectHapticDevice* device, const ResectHapticPose* pose) {
  SimulatedHand& hand = handOf(device);
  hand.wanted = *pose;
  if (!hand.placed) std::copy_n(pose->position, 3, hand.at);
  hand.placed = true;
}

int readHand(ResectHapticDevice* device, ResectHapticPose* pose) {
  SimulatedHand& hand = handOf(device);
  const double time = now();
  advance(hand, hand.step > 0 ? hand.step : std::clamp(time - hand.last, 0.0, kLongest));
  hand.last = time;
  *pose = hand.wanted;  // it turns as the person wants
  for (int a = 0; a < 3; ++a)
    pose->position[a] = hand.resolution > 0
                            ? hand.resolution * std::round(hand.at[a] / hand.resolution)
                            : hand.at[a];
  return 0;
}

int writeHand(ResectHapticDevice* device, const ResectHapticForce* force) {
  std::copy_n(force->force, 3, handOf(device).force);
  return 0;
}

const char* errorOf(ResectHapticDevice*) { return lastError.c_str(); }

constexpr ResectHapticDeviceFunctions kFunctions = {RESECT_HAPTIC_DEVICE_VERSION,
                                                    "simulated hand",
                                                    openHand,
                                                    closeHand,
                                                    readHand,
                                                    writeHand,
                                                    errorOf,
                                                    intendHand};

}  // namespace

const ResectHapticDeviceFunctions* resect_haptic_device(void) { return &kFunctions; }
