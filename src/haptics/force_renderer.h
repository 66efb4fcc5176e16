// Computes the force on the hand between two frames of the simulation. 1000 times a second, the
// local model of the instrument (haptics/local_model.h) is evaluated at the present pose of the
// hand. When a new model arrives, the force changes gradually.
#pragma once

#include "haptics/local_model.h"

namespace resect {

// Pose (m), velocity (m/s) and spin (rad/s) of the instrument that a hand holds, in the coordinates
// of the local model.
struct HandState {
  Pose pose;
  Vec3 velocity = Vec3::Zero(), spin = Vec3::Zero();
};

struct Wrench {
  Vec3 force = Vec3::Zero();   // N
  Vec3 torque = Vec3::Zero();  // about HandState::pose.position, N m
};

// The force that the model gives for the hand's pose. This pose may differ from the pose that the
// instrument has in the simulation. Contact planes push and never pull. Coulomb's law limits
// friction. Grips (places where the instrument holds tissue) act in all directions. The
// function allocates no memory.
Wrench forceAt(const LocalModel& model, const HandState& hand);

class ForceRenderer {
 public:
  // mostForce: largest force that render() returns, N. Larger forces are scaled down to it. Throws
  // Error unless mostForce > 0.
  explicit ForceRenderer(double mostForce = 20);

  // Replaces the model by a new one. hand, now: the same values as in the next call of render().
  // The force changes gradually to the force of the new model. The change takes as long as the time
  // between the arrivals of the last two models, but at least 1 and at most 4 durations of a frame.
  void take(const LocalModel& model, const HandState& hand, double now);
  // The force on the hand. now: time of a steady clock, s; must not decrease from call to call.
  Wrench render(const HandState& hand, double now) const;

  const LocalModel& model() const { return model_; }
  // How much the last take() changed the force of the model, N. It is the magnitude of the
  // difference between the forces of the new and the previous model, both for the hand's pose at
  // that moment.
  double correction() const { return correction_; }

 private:
  double mostForce_;
  LocalModel model_;
  Wrench fading_;  // force before the last take() minus force of the new model, at that moment
  double taken_ = 0, fadeTime_ = 0, correction_ = 0;
};

}  // namespace resect
