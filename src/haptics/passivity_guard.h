// Keeps the hand from ever receiving more energy than it has given: time-domain passivity after
// Hannaford and Ryu 2002.
//
// The observer adds up the work that the force does on the hand. A device holds a force until the
// next one is written, so the work of a cycle is exactly the force times the way. The controller
// looks one cycle ahead: before the account is overdrawn it makes the force smaller, and lets it
// grow again slowly.
#pragma once

#include "haptics/force_renderer.h"

namespace resect {

class PassivityGuard {
 public:
  // mostForce: of all that is written, N, > 0.
  explicit PassivityGuard(double mostForce) : mostForce_(mostForce) {}

  // To be called first in each cycle, with the pose just read from the device.
  void moved(const Pose& pose);
  // The force to write in this cycle: `wanted`, or less; or one that brakes the hand. dt: time to
  // the next cycle, s, > 0. The hand is expected to move in the next cycle as in the last one.
  Wrench allow(const Wrench& wanted, double dt);

  // Work of the forces on the hand, J; below 0 when the hand has given energy. And its largest
  // value so far, at least 0.
  double energyToHand() const { return energy_; }
  double mostEnergyToHand() const { return most_; }
  std::int64_t interventions() const { return interventions_; }  // cycles with less than wanted

 private:
  double mostForce_;
  bool started_ = false;
  Pose last_;
  Vec3 way_ = Vec3::Zero(), turn_ = Vec3::Zero();  // in the last cycle, m and rad
  double largestWay_ = 0;                          // in recent cycles, m
  double share_ = 1;                               // of the wanted force that is written
  Wrench written_;
  // Energy that the hand may still be given, J. As -energy_, but at most kMostAccount.
  double account_ = 0;
  double energy_ = 0, most_ = 0;
  std::int64_t interventions_ = 0;
};

}  // namespace resect
