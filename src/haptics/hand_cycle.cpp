#include "haptics/hand_cycle.h"

#include <algorithm>

namespace resect {
namespace {

// Time constant of the speeds that damping sees, s: differences of two poses are noisy.
constexpr double kSpeedTime = 4e-3;

}  // namespace

HandCycle::HandCycle(double mostForce, const Pose& start, double now)
    : renderer_(mostForce), guard_(mostForce), read_(now) {
  motion_.pose = start;
  guard_.moved(start);
}

Wrench HandCycle::next(const Pose& pose, const LocalModel* arrived, double now) {
  guard_.moved(pose);
  const double dt = std::max(now - read_, 1e-6), share = dt / (dt + kSpeedTime);
  const Vec3 velocity = (pose.position - motion_.pose.position) / dt;
  const Vec3 spin = rotationVector(pose.rotation * motion_.pose.rotation.conjugate()) / dt;
  motion_.velocity += share * (velocity - motion_.velocity);
  motion_.spin += share * (spin - motion_.spin);
  motion_.pose = pose;
  read_ = now;
  if (arrived) renderer_.take(*arrived, motion_, now);
  return guard_.allow(renderer_.render(motion_, now), kHapticPeriod);
}

}  // namespace resect
