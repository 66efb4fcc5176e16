#include "haptics/passivity_guard.h"

#include <algorithm>
#include <cmath>

namespace resect {
namespace {

// J: what the hand gave beyond this was dissipated for sure, and would hide that energy is made.
// Half a kilogram of tissue lifted by 10 cm.
constexpr double kMostAccount = 0.5;
// m/s^2: by how much a hand may go farther than in the last cycle.
constexpr double kHandAcceleration = 60;
// Of the account, at most so much in a cycle: so the force fades rather than ends.
constexpr double kShareOfAccount = 0.05;
constexpr double kRecovery = 0.03;  // s, in which a force that was taken away comes back
// The largest way of recent cycles is forgotten by so much in each: encoders move in steps.
constexpr double kRemembers = 0.95;
// While the account is overdrawn the hand is braked, N s/m.
constexpr double kBrake = 4;

}  // namespace

void PassivityGuard::moved(const Pose& pose) {
  if (started_) {
    way_ = pose.position - last_.position;
    turn_ = rotationVector(pose.rotation * last_.rotation.conjugate());
    largestWay_ = std::max(way_.norm(), kRemembers * largestWay_);
    const double work = written_.force.dot(way_) + written_.torque.dot(turn_);
    energy_ += work;
    most_ = std::max(most_, energy_);
    account_ = std::min(account_ - work, kMostAccount);
  }
  started_ = true;
  last_ = pose;
}

Wrench PassivityGuard::allow(const Wrench& wanted, double dt) {
  const double farther = 2 * kHandAcceleration * dt * dt;
  const double reserve = (farther + largestWay_) * wanted.force.norm();
  const double most = std::max(0.0, kShareOfAccount * (account_ - reserve));
  const double push = wanted.force.dot(way_) + wanted.torque.dot(turn_);
  share_ = std::min(1.0, share_ + dt / kRecovery);
  if (push > 0) share_ = std::min(share_, most / push);
  if (share_ < 1) ++interventions_;
  written_ = {share_ * wanted.force, share_ * wanted.torque};
  if (account_ < 0) written_.force -= kBrake / dt * way_;
  if (const double force = written_.force.norm(); force > mostForce_)
    written_.force *= mostForce_ / force;
  return written_;
}

}  // namespace resect
