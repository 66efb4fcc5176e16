// One cycle of 1 kHz for one hand: from the pose that was read to the force to write.
#pragma once

#include "haptics/passivity_guard.h"

namespace resect {

inline constexpr double kHapticPeriod = 1e-3;  // s

// Allocates nothing. For one thread.
class HandCycle {
 public:
  // mostForce: that the device renders, N, > 0. start: pose of the hand, world or workspace, m; the
  // local models are in the same coordinates. now: time of a steady clock, s.
  HandCycle(double mostForce, const Pose& start, double now);

  // pose: as just read. arrived: a local model that has arrived since the last cycle, or null.
  // Returns the force to write at once.
  Wrench next(const Pose& pose, const LocalModel* arrived, double now);

  const ForceRenderer& renderer() const { return renderer_; }
  const PassivityGuard& guard() const { return guard_; }

 private:
  ForceRenderer renderer_;
  PassivityGuard guard_;
  HandState motion_;
  double read_;  // when the pose was read last, s
};

}  // namespace resect
