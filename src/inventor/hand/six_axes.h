// Converts the deflection of a 3D mouse's cap to a motion of the tool in hand or of the camera.
//
// A person can push the cap along three axes, and turn the cap about these axes: to the right, up,
// and away from the person. The deflection of the cap determines the velocity of the motion.
#pragma once

#include "base/vec.h"

namespace resect {

// Deflection of the cap along and about each axis, in counts of the device. The deflection is 0 at
// rest, and at most about 350 in either direction.
struct SixAxes {
  Vec3 push = Vec3::Zero();  // right, up, away
  Vec3 turn = Vec3::Zero();  // about the same axes, right-handed
};

// A motion along and about three axes of the view: to the right, up, and away from the viewer.
struct ViewMotion {
  Vec3 move = Vec3::Zero();  // right, up, away, m
  Vec3 turn = Vec3::Zero();  // about the same axes, right-handed, rad
};

// The motion during a time of `seconds`. A time above 0.1 s counts as 0.1 s. On each axis the first
// 12 counts of the deflection have no effect, so that a hand can rest on the cap.
ViewMotion motionOf(const SixAxes& axes, double seconds);

}  // namespace resect
