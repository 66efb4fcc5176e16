// Rotations that give the same bits on every machine. Use these functions instead of Eigen's, which
// call the sine and arc functions of the C library. The functions here call base/elementary.h.
#pragma once

#include <Eigen/Geometry>

#include "base/vec.h"

namespace resect {

// The rotation by `angle` (rad, |angle| <= 1e6) about a unit axis: counter-clockwise for a viewer
// at whom the axis points.
Eigen::Quaterniond rotationAbout(const Vec3& axis, double angle);

// The angle of the smallest rotation that turns orientation a into b, 0 to pi rad.
double angleBetween(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b);

// The rotation axis, a unit vector, times the angle (rad, at most pi) of a unit quaternion; zero
// for the identity.
Vec3 rotationVector(const Eigen::Quaterniond& rotation);

// Interpolates from a (share 0) to b (share 1) along the shorter great circle (Shoemake 1985).
Eigen::Quaterniond slerp(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b, double share);

}  // namespace resect
