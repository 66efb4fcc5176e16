// Functions for rotations. Their results have the same bits on every machine. Use them instead of
// Eigen's functions. Eigen's functions call the sine and arc functions of the C library, whose last
// bits may differ between machines. The functions of this header call base/elementary.h.
#pragma once

#include <Eigen/Geometry>

#include "base/vec.h"

namespace resect {

// The rotation by `angle` about `axis`. angle: rad, |angle| <= 1e6. axis: unit vector. The rotation
// is counter-clockwise for a viewer at whom the axis points.
Eigen::Quaterniond rotationAbout(const Vec3& axis, double angle);

// The angle of the smallest rotation that turns orientation a into orientation b, 0 to pi rad.
double angleBetween(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b);

// A rotation as a vector: its direction is the rotation axis, and its length is the angle, 0 to pi
// rad. The identity gives the zero vector. rotation: unit quaternion.
Vec3 rotationVector(const Eigen::Quaterniond& rotation);

// Interpolates along the shorter arc of a great circle (Shoemake 1985). The result is a for share
// 0, and b for share 1.
Eigen::Quaterniond slerp(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b, double share);

}  // namespace resect
