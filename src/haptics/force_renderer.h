// The force on the hand between two frames of the simulation: a local model evaluated where the
// hand is now, 1000 times a second, without steps when the next model arrives.
#pragma once

#include "haptics/local_model.h"

namespace resect {

// Where a hand holds its instrument, and how it moves; world, m, m/s and rad/s.
struct HandMotion {
  Pose pose;
  Vec3 velocity = Vec3::Zero(), spin = Vec3::Zero();
};

struct Wrench {
  Vec3 force = Vec3::Zero();   // N
  Vec3 torque = Vec3::Zero();  // about the position of the hand's pose, N m
};

// What the model says of an instrument that is elsewhere than in the simulation. Planes push and
// never pull; friction keeps to Coulomb's limit; grips pull both ways. Allocates nothing.
Wrench forceAt(const LocalModel& model, const HandMotion& hand);

class ForceRenderer {
 public:
  // mostForce: N, > 0; forces are shortened to it. Throws Error if it is not.
  explicit ForceRenderer(double mostForce = 20);

  // A model has arrived. hand, now: as in the latest render(). From now on the new model counts.
  // What it changes at the hand fades in over the time between two models.
  void take(const LocalModel& model, const HandMotion& hand, double now);
  // The force on the hand. now: time of a steady clock, s, not before that of earlier calls.
  Wrench render(const HandMotion& hand, double now) const;

  const LocalModel& model() const { return model_; }
  // How much the last model differed from the one before where the hand was, N: what the model
  // before had not foreseen.
  double correction() const { return correction_; }

 private:
  double mostForce_;
  LocalModel model_;
  Wrench fading_;  // added to the model's force when it arrived
  double taken_ = 0, fadeTime_ = 0, correction_ = 0;
};

}  // namespace resect
