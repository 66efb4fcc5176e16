// How far does the cap of a 3D mouse move what is in hand, or the view?
//
// The cap is pushed and turned along and about the right, up and away axes of the view, as far as
// the hand pushes it: it says how fast, not where.
#pragma once

#include "base/vec.h"

namespace resect {

// As the device counts: 0 at rest, some 350 at the end of the way.
struct SixAxes {
  Vec3 push = Vec3::Zero();  // to the right, up, away from the person
  Vec3 turn = Vec3::Zero();  // about the same axes, right-handed
};

struct ViewMotion {
  Vec3 move = Vec3::Zero();  // m to the right, up, away
  Vec3 turn = Vec3::Zero();  // rad about the same axes
};

// What the cap does in this time. Axes that are hardly pushed stay still.
ViewMotion motionOf(const SixAxes& axes, double seconds);

}  // namespace resect
