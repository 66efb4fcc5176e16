// Converts the deflection of a 3D mouse's cap to motion of the tool in hand or of the view.
//
// The cap can be pushed along three axes of the view (right, up, away from the person) and turned
// about them. Its deflection sets a velocity.
#pragma once

#include "base/vec.h"

namespace resect {

// Deflection of the cap along and about each axis, in counts of the device: 0 at rest, at most
// about 350 in either direction.
struct SixAxes {
  Vec3 push = Vec3::Zero();  // right, up, away
  Vec3 turn = Vec3::Zero();  // about the axes of `push`, right-handed
};

// A motion along and about the three axes of the view.
struct ViewMotion {
  Vec3 move = Vec3::Zero();  // right, up, away, m
  Vec3 turn = Vec3::Zero();  // about the axes of `move`, right-handed, rad
};

// The motion during a time of `seconds`. A time of more than 0.1 s counts as 0.1 s. On each axis
// the first 12 counts of the deflection have no effect, so that a hand may rest on the cap.
ViewMotion motionOf(const SixAxes& axes, double seconds);

}  // namespace resect
