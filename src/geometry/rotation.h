// Rotations that give the same bits on every machine. In place of Eigen's functions that call the C
// library's sine and arc functions, those here call base/elementary.h.
#pragma once

#include <Eigen/Geometry>

#include "base/vec.h"

namespace resect {

// The rotation by `angle` (rad, |angle| <= 1e6) about a unit axis, counter-clockwise as seen from
// the tip of the axis.
Eigen::Quaterniond rotationAbout(const Vec3& axis, double angle);

// The angle of the smallest rotation from one orientation to the other, 0 to pi rad.
double angleBetween(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b);

// Axis times angle (rad, at most pi) of a unit quaternion; zero if it does not rotate.
Vec3 rotationVector(const Eigen::Quaterniond& rotation);

// The rotation between a (at share 0) and b (at share 1) along the shorter great circle (Shoemake
// 1985).
Eigen::Quaterniond slerp(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b, double share);

}  // namespace resect
