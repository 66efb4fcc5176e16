// Converts a text that describes the orientation of a model to a rotation. The rotation leads from
// the model's axes to the world's axes.
//
// In the world the patient lies on the back, and the surgeon stands at the feet: +X points to the
// patient's left, +Y up to the front (anterior), +Z to the feet (docs/architecture.md).
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "base/vec.h"

namespace resect {

// letters: the directions of the model's x, y and z axis in the patient, one letter for each: L or
// R (the patient's left or right), A or P (front or back), S or H (head), I or F (feet). Examples:
// "LPS", "RAS". Throws a usage Error if the letters are not three directions at right angles to
// each other. Also throws a usage Error if the axes are left-handed, since no rotation leads from
// such axes to the world's axes.
Eigen::Quaterniond orientationOf(const std::string& letters);

// text: three angles in degrees, such as "30,0,90". The model is rotated first by the first angle
// about the world's X axis, then by the second about Y, then by the third about Z. Throws a usage
// Error if the text is not three numbers.
Eigen::Quaterniond turnOf(const std::string& text);

}  // namespace resect
