// Converts the deflection of a 3D mouse's cap to motion of the tool in hand or of the view.
//
// The cap can be pushed along three axes of the view (right, up, away from the person) and turned
// about them. Its deflection sets a velocity.
#pragma once

#include "base/vec.h"

namespace resect {

// Deflection, in counts of the device along or about each axis: 0 at rest, some 350 at most.
struct SixAxes {
  Vec3 push = Vec3::Zero();  // right, up, away
  Vec3 turn = Vec3::Zero();  // about each of these axes, right-handed
};

struct ViewMotion {
  Vec3 move = Vec3::Zero();  // right, up, away, m
  Vec3 turn = Vec3::Zero();  // about each of these axes, rad
};

// The motion during `seconds`, of which at most 0.1 count. On each axis a small deflection counts
// as zero.
ViewMotion motionOf(const SixAxes& axes, double seconds);

}  // namespace resect
