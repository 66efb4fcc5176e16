// Renders the force on the hand between two frames of the simulation. 1000 times a second, the
// local model is evaluated at the present pose of the hand. The force does not jump when a new
// model arrives.
#pragma once

#include "haptics/local_model.h"

namespace resect {

// Pose and motion of the instrument that a hand holds, in the coordinates of the local model; m,
// m/s and rad/s.
struct HandState {
  Pose pose;
  Vec3 velocity = Vec3::Zero(), spin = Vec3::Zero();
};

struct Wrench {
  Vec3 force = Vec3::Zero();   // N
  Vec3 torque = Vec3::Zero();  // about the position of the hand's pose, N m
};

// The force of the model on the instrument at the hand's pose, which may differ from the pose that
// the instrument has in the simulation. Planes push and never pull, friction is limited by
// Coulomb's law, and grips act in all directions. Allocates nothing.
Wrench forceAt(const LocalModel& model, const HandState& hand);

class ForceRenderer {
 public:
  // mostForce: N; a larger force is scaled down to it. Throws Error unless mostForce > 0.
  explicit ForceRenderer(double mostForce = 20);

  // Takes over a new model. hand, now: the same as for the render() that follows. The force does
  // not jump: its change fades in over the time between the arrivals of the last two models, but
  // over at least 1 and at most 4 durations of a frame.
  void take(const LocalModel& model, const HandState& hand, double now);
  // The force on the hand. now: time of a steady clock, s, not before the time of earlier calls.
  Wrench render(const HandState& hand, double now) const;

  const LocalModel& model() const { return model_; }
  // Magnitude of the difference between the forces, N, that the last two models give at the pose
  // that the hand had when the last model arrived.
  double correction() const { return correction_; }

 private:
  double mostForce_;
  LocalModel model_;
  Wrench fading_;  // previous force minus new force when the model arrived
  double taken_ = 0, fadeTime_ = 0, correction_ = 0;
};

}  // namespace resect
