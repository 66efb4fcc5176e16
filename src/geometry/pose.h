// Position and rotation of a rigid body.
#pragma once

#include "base/vec.h"
#include "geometry/rotation.h"

namespace resect {

// The pose maps a point of the body to the world: world point = rotation * body point + position.
// `rotation` is a unit quaternion. `position` is in m.
struct Pose {
  Vec3 position = Vec3::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();

  template <class Visitor>
  void visit(Visitor& v) {
    v("position", position), v("rotation", rotation);
  }

  Vec3 operator*(const Vec3& p) const { return rotation * p + position; }
  Pose inverse() const {
    const Eigen::Quaterniond back = rotation.conjugate();
    return {back * -position, back};
  }
};

inline bool isFinite(const Pose& pose) {
  return pose.position.allFinite() && pose.rotation.coeffs().allFinite();
}

// A pose between a and b: a for share 0, b for share 1. The position is interpolated linearly. The
// rotation is interpolated along the shorter arc of a great circle (slerp() in
// geometry/rotation.h).
inline Pose interpolate(const Pose& a, const Pose& b, double share) {
  return {a.position + share * (b.position - a.position), slerp(a.rotation, b.rotation, share)};
}

}  // namespace resect
