// Rotations that give the same bits on every machine: what Eigen would ask the C library's sines
// and arcs for goes through base/elementary.h.
#pragma once

#include <Eigen/Geometry>

#include "base/vec.h"

namespace resect {

// By `angle` (rad, |angle| <= 1e6) about a unit axis, counter-clockwise as seen from its tip.
Eigen::Quaterniond rotationAbout(const Vec3& axis, double angle);

// The angle between two orientations: the least rotation that takes one to the other, in [0, pi]
// rad.
double angleBetween(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b);

// Axis times angle (rad, at most pi) of a unit quaternion; zero for none.
Vec3 rotationVector(const Eigen::Quaterniond& rotation);

// From a at share 0 to b at share 1 along the shorter great circle (Shoemake 1985).
Eigen::Quaterniond slerp(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b, double share);

}  // namespace resect
