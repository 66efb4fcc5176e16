// One cycle of the loop of 1 kHz for one hand: computes the force to write from the pose that was
// read.
#pragma once

#include "haptics/passivity_guard.h"

namespace resect {

inline constexpr double kHapticPeriod = 1e-3;  // s

// Allocates nothing. To be used by one thread only.
class HandCycle {
 public:
  // mostForce: largest force that the device renders, N, > 0. start: first pose of the hand, m; in
  // the world or in the device's workspace, as all poses and local models that follow. now: time of
  // a steady clock, s.
  HandCycle(double mostForce, const Pose& start, double now);

  // pose: just read from the device. arrived: a local model that has arrived since the last cycle,
  // or null. Returns the force, which is to be written at once.
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
