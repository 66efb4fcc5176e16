// Converts the deflection of a 3D mouse to motion of the tool in hand or of the view.
//
// The cap is pushed along and turned about the right, up and away axes of the view; the deflection
// is a velocity.
#pragma once

#include "base/vec.h"

namespace resect {

// In counts of the device: 0 at rest, some 350 at full deflection.
struct SixAxes {
  Vec3 push = Vec3::Zero();  // to the right, up, away from the person
  Vec3 turn = Vec3::Zero();  // about the same axes, right-handed
};

struct ViewMotion {
  Vec3 move = Vec3::Zero();  // m to the right, up, away
  Vec3 turn = Vec3::Zero();  // rad about the same axes
};

// The motion during this time. Small deflections count as zero, axis by axis.
ViewMotion motionOf(const SixAxes& axes, double seconds);

}  // namespace resect
