#include "geometry/ray.h"

#include <Eigen/Geometry>
#include <limits>
#include <utility>

namespace resect {

double firstMeeting(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
  // Tolerance for rounding of barycentric coordinates, which are 0 to 1 inside.
  constexpr double kSlack = 1e-9;
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const Vec3 ab = b - a, ac = c - a, across = ray.direction.cross(ac);
  const double determinant = ab.dot(across);
  if (determinant == 0) return kNever;
  const Vec3 from = ray.origin - a, turned = from.cross(ab);
  const double shareOfB = from.dot(across) / determinant;
  const double shareOfC = ray.direction.dot(turned) / determinant;
  if (!(shareOfB >= -kSlack && shareOfC >= -kSlack && shareOfB + shareOfC <= 1 + kSlack))
    return kNever;
  const double t = ac.dot(turned) / determinant;
  return t >= 0 ? t : kNever;
}

bool meets(const Ray& ray, const Aabb& box) {
  if (box.empty()) return false;
  double enters = 0, leaves = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double from = ray.origin[axis], way = ray.direction[axis];
    if (way == 0) {
      if (from < box.min[axis] || from > box.max[axis]) return false;
      continue;
    }
    double first = (box.min[axis] - from) / way, second = (box.max[axis] - from) / way;
    if (first > second) std::swap(first, second);
    enters = std::max(enters, first);
    leaves = std::min(leaves, second);
  }
  return enters <= leaves;
}

}  // namespace resect
