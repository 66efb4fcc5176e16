// The force on the hand between two frames of the simulation: a local model evaluated where the
// hand is now, 1000 times a second, without steps when the next model arrives.
#pragma once

#include "haptics/local_model.h"

namespace resect {

// Where a hand holds its instrument, and how it moves; world, m, m/s and rad/s.
struct HandState {
  Pose pose;
  Vec3 velocity = Vec3::Zero(), spin = Vec3::Zero();
};

struct Wrench {
  Vec3 force = Vec3::Zero();   // N
  Vec3 torque = Vec3::Zero();  // about the position of the hand's pose, N m
};

// The model's force on an instrument whose pose differs from that of the simulation. Planes push
// and never pull; friction keeps to Coulomb's limit; grips pull both ways. Allocates nothing.
Wrench forceAt(const LocalModel& model, const HandState& hand);

class ForceRenderer {
 public:
  // mostForce: N, > 0; forces are shortened to it. Throws Error if it is not.
  explicit ForceRenderer(double mostForce = 20);

  // Takes over a new model. hand, now: those of the render() that follows. The force does not jump:
  // the change fades in over the time between two models.
  void take(const LocalModel& model, const HandState& hand, double now);
  // The force on the hand. now: time of a steady clock, s, not before that of earlier calls.
  Wrench render(const HandState& hand, double now) const;

  const LocalModel& model() const { return model_; }
  // When the last model arrived: how far its force at the hand's pose was from that of the previous
  // model, N.
  double correction() const { return correction_; }

 private:
  double mostForce_;
  LocalModel model_;
  Wrench fading_;  // added to the model's force when it arrived
  double taken_ = 0, fadeTime_ = 0, correction_ = 0;
};

}  // namespace resect
