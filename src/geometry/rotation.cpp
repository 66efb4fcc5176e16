#include "geometry/rotation.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"

namespace resect {

Eigen::Quaterniond rotationAbout(const Vec3& axis, double angle) {
  const Vec3 v = math::sin(0.5 * angle) * axis;
  return {math::cos(0.5 * angle), v.x(), v.y(), v.z()};
}

double angleBetween(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  const Eigen::Quaterniond d = a * b.conjugate();
  return 2 * math::atan2(d.vec().norm(), std::abs(d.w()));
}

Vec3 rotationVector(const Eigen::Quaterniond& rotation) {
  const double sine = rotation.vec().norm();
  if (!(sine > 0)) return Vec3::Zero();
  const double angle = 2 * math::atan2(sine, std::abs(rotation.w()));
  return (rotation.w() < 0 ? -angle : angle) / sine * rotation.vec();
}

Eigen::Quaterniond slerp(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b, double share) {
  const double cosine = a.dot(b), size = std::abs(cosine);
  double first = 1 - share, second = share;
  if (size < 1 - 1e-15) {
    const double angle = math::acos(size), sine = math::sin(angle);
    first = math::sin((1 - share) * angle) / sine;
    second = math::sin(share * angle) / sine;
  }
  if (cosine < 0) second = -second;
  Eigen::Quaterniond result;
  result.coeffs() = first * a.coeffs() + second * b.coeffs();
  return result;
}

}  // namespace resect
