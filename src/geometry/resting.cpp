#include "geometry/resting.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "geometry/measures.h"

namespace resect {

namespace {

// Height of the centroid over the table when `up` is turned upwards.
double centroidHeight(const std::vector<Vec3>& fromCentroid, const Vec3& up) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Vec3& p : fromCentroid) lowest = std::min(lowest, p.dot(up));
  return -lowest;
}

}  // namespace

Eigen::Quaterniond restingRotation(const TriangleMesh& mesh) {
  if (mesh.points.empty()) return Eigen::Quaterniond::Identity();
  // Some thousand points tell the shape; the refinement below is far finer than what they miss.
  const Vec3 centre = centroid(mesh);
  const std::size_t stride = 1 + mesh.points.size() / 10000;
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < mesh.points.size(); i += stride)
    points.push_back(mesh.points[i] - centre);

  Vec3 best = Vec3::UnitY();
  double height = centroidHeight(points, best);
  const auto consider = [&](const Vec3& up) {
    const double h = centroidHeight(points, up);
    // A clear gain is asked for, so that a body that already lies stays.
    if (h < height * (1.0 - 1e-6)) height = h, best = up;
  };
  constexpr int kDirections = 2000;
  for (int i = 0; i < kDirections; ++i) {
    const double y = 1.0 - (2.0 * i + 1.0) / kDirections, r = std::sqrt(1.0 - y * y);
    const double a = std::numbers::pi * (3.0 - std::sqrt(5.0)) * i;
    consider({r * std::cos(a), y, r * std::sin(a)});
  }
  for (double step = 0.03; step > 0.0015; step *= 0.6) {
    const Vec3 from = best, side = from.unitOrthogonal(), other = from.cross(side);
    for (int k = 0; k < 8; ++k) {
      const double a = std::numbers::pi / 4.0 * k;
      consider((from + step * (std::cos(a) * side + std::sin(a) * other)).normalized());
    }
  }
  return Eigen::Quaterniond::FromTwoVectors(best, Vec3::UnitY());
}

Pose standOnTable(const TriangleMesh& mesh, const Eigen::Quaterniond& rotation) {
  Aabb box;
  for (const Vec3& p : mesh.points) box.grow(rotation * p);
  if (box.empty()) return {Vec3::Zero(), rotation};
  return {Vec3(-box.centre().x(), -box.min.y(), -box.centre().z()), rotation};
}

}  // namespace resect
