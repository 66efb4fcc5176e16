// Limits the force on the hand so that the hand does not receive more energy than it has given
// (time-domain passivity control after Hannaford and Ryu 2002).
//
// The guard adds up the work that the force does on the hand. A device holds a force until the next
// force is written. So the work in a cycle is exactly the force times the displacement of the hand.
// From this work the guard computes an account: the energy that the hand may still receive. The
// guard looks one cycle ahead, and reduces the force before the account becomes negative. When the
// reduction is no longer needed, the force grows again within 30 ms.
#pragma once

#include "haptics/force_renderer.h"

namespace resect {

class PassivityGuard {
 public:
  // mostForce: upper limit of the forces that allow() returns, N, > 0.
  explicit PassivityGuard(double mostForce) : mostForce_(mostForce) {}

  // Call this first in each cycle, with the pose that was just read from the device.
  void moved(const Pose& pose);
  // The force to write in this cycle. It is `wanted`, or a smaller force in the same direction. The
  // function assumes that the hand will move in the next cycle about as in the last one. If the
  // hand moves differently, the account can become negative. As long as the account is negative, a
  // force that brakes the hand is added. dt: time to the next cycle, s, > 0.
  Wrench allow(const Wrench& wanted, double dt);

  // energyToHand() is the work that the forces have done on the hand so far, J. It is negative if
  // the hand has given energy. mostEnergyToHand() is the largest value that energyToHand() has had
  // so far, and at least 0.
  double energyToHand() const { return energy_; }
  double mostEnergyToHand() const { return most_; }
  std::int64_t interventions() const { return interventions_; }  // cycles with reduced force

 private:
  double mostForce_;
  bool started_ = false;
  Pose last_;
  // Displacement (m) and rotation (rad) of the hand in the last cycle.
  Vec3 way_ = Vec3::Zero(), turn_ = Vec3::Zero();
  double largestWay_ = 0;  // largest |way_| of recent cycles, m; decays by 5 % in each cycle
  double share_ = 1;       // fraction of the wanted force that is written
  Wrench written_;
  // The account: energy that the hand may still receive, J. When energy_ grows, the account shrinks
  // by the same amount. When energy_ shrinks, the account grows by this amount. The account never
  // exceeds 0.5 J.
  double account_ = 0;
  double energy_ = 0, most_ = 0;
  std::int64_t interventions_ = 0;
};

}  // namespace resect
