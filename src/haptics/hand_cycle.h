// One cycle of the haptic loop (1 kHz) for one hand. It computes the force for the device from the
// pose that was read from the device.
#pragma once

#include "haptics/passivity_guard.h"

namespace resect {

inline constexpr double kHapticPeriod = 1e-3;  // s

// The functions allocate no memory. Only one thread may use an object of this class.
class HandCycle {
 public:
  // mostForce: largest force that the device renders, N, > 0. start: first pose of the hand, m. It
  // may be in coordinates of the world or of the device's workspace; all later poses and local
  // models must have the same coordinates. now: time of a steady clock, s.
  HandCycle(double mostForce, const Pose& start, double now);

  // Runs one cycle and returns the force, which the caller must write to the device at once. pose:
  // the pose that was just read from the device. arrived: a local model that has arrived since the
  // last cycle; null if there is none.
  Wrench next(const Pose& pose, const LocalModel* arrived, double now);

  const ForceRenderer& renderer() const { return renderer_; }
  const PassivityGuard& guard() const { return guard_; }

 private:
  ForceRenderer renderer_;
  PassivityGuard guard_;
  HandState motion_;
  double read_;  // time of the last pose, s
};

}  // namespace resect
