// Limits the force so that the hand never receives more energy than it has given: time-domain
// passivity control after Hannaford and Ryu 2002.
//
// The observer adds up the work that the force does on the hand. A device holds a force until the
// next one is written, so the work of a cycle is exactly the force times the displacement of the
// hand. From this work the controller keeps an account of the energy that the hand may still
// receive. It looks one cycle ahead: it reduces the force before the account becomes negative, and
// then lets the force grow again within 30 ms.
#pragma once

#include "haptics/force_renderer.h"

namespace resect {

class PassivityGuard {
 public:
  // mostForce: upper limit of every force that is written, N, > 0.
  explicit PassivityGuard(double mostForce) : mostForce_(mostForce) {}

  // To be called first in each cycle, with the pose just read from the device.
  void moved(const Pose& pose);
  // The force to write in this cycle: `wanted`, a smaller force, or, if the account is negative, a
  // force that also brakes the hand. dt: time to the next cycle, s, > 0. The hand is expected to
  // move in the next cycle as in the last one.
  Wrench allow(const Wrench& wanted, double dt);

  // energyToHand(): work of the forces on the hand, J; negative if the hand has given energy.
  // mostEnergyToHand(): its largest value so far, at least 0.
  double energyToHand() const { return energy_; }
  double mostEnergyToHand() const { return most_; }
  std::int64_t interventions() const { return interventions_; }  // cycles with reduced force

 private:
  double mostForce_;
  bool started_ = false;
  Pose last_;
  Vec3 way_ = Vec3::Zero(), turn_ = Vec3::Zero();  // hand's motion in the last cycle, m and rad
  double largestWay_ = 0;                          // largest |way_|, m; decays by 5 % in a cycle
  double share_ = 1;                               // fraction of the wanted force that is written
  Wrench written_;
  // The account: energy that the hand may still receive, J. It changes as -energy_ does, but is at
  // most 0.5 J (kMostAccount).
  double account_ = 0;
  double energy_ = 0, most_ = 0;
  std::int64_t interventions_ = 0;
};

}  // namespace resect
