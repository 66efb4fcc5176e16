// How a model's axes lie in the patient, as people write it, turned into a rotation in the room.
//
// In the room the patient lies on the back, and the surgeon stands at the feet: +X points to the
// patient's left, +Y up to the front (anterior), +Z to the feet (docs/architecture.md).
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "base/vec.h"

namespace resect {

// letters: where the model's x, y and z axis point to, one letter for each: L or R (the patient's
// left or right), A or P (front or back), S or H (head), I or F (feet); such as "LPS" or "RAS".
// Throws a usage Error if they are not three directions at right angles to each other, or if the
// axes are left-handed, which no rotation can give.
Eigen::Quaterniond orientationOf(const std::string& letters);

// text: "30,0,90": degrees about the room's X, then Y, then Z axis. Throws a usage Error if it is
// not three numbers.
Eigen::Quaterniond turnOf(const std::string& text);

}  // namespace resect
