#include "geometry/resting_pose.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/elementary.h"
#include "base/parallel.h"
#include "geometry/farthest_point.h"
#include "geometry/measures.h"

namespace resect {
namespace {

// Directions spread evenly over the sphere (golden spiral).
std::vector<Vec3> directions(int count) {
  std::vector<Vec3> result;
  for (int i = 0; i < count; ++i) {
    const double y = 1 - 2 * (i + 0.5) / count, angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
    const double r = std::sqrt(1 - y * y);
    result.emplace_back(r * math::cos(angle), y, r * math::sin(angle));
  }
  return result;
}

// The farthest points in many directions: nearly all vertices of the convex hull that a table can
// touch.
std::vector<Vec3> outermostPoints(const TriangleMesh& mesh, const Vec3& centre) {
  const FarthestPoint farthest(mesh.points);
  std::vector<Vec3> result = directions(1500);
  parallelFor(result.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      result[i] = mesh.points[farthest.along(result[i])] - centre;
  });
  return result;
}

}  // namespace

Eigen::Quaterniond restingRotation(const TriangleMesh& mesh) {
  if (!(std::abs(volume(mesh)) > 0)) return Eigen::Quaterniond::Identity();
  const std::vector<Vec3> points = outermostPoints(mesh, centroid(mesh));
  // Height of the centre over the table when `down` points to the table.
  const auto height = [&](const Vec3& down) {
    double farthest = 0;
    for (const Vec3& p : points) farthest = std::max(farthest, down.dot(p));
    return farthest;
  };
  Vec3 down(0, -1, 0);
  double lowest = height(down);
  for (double step = 0.3; step > 1e-3;) {
    const Vec3 u = down.unitOrthogonal(), v = down.cross(u);
    Vec3 best = down;
    for (int i = 0; i < 16; ++i) {
      const double angle = 2 * std::numbers::pi * i / 16;
      const Vec3 d = (down + step * (math::cos(angle) * u + math::sin(angle) * v)).normalized();
      if (const double h = height(d); h < lowest) {
        lowest = h;
        best = d;
      }
    }
    if (best == down) step *= 0.5;
    down = best;
  }
  return Eigen::Quaterniond::FromTwoVectors(down, Vec3(0, -1, 0));
}

Pose standOnTable(const TriangleMesh& mesh, const Eigen::Quaterniond& rotation) {
  Aabb box;
  for (const Vec3& p : mesh.points) box.grow(rotation * p);
  if (box.empty()) return {Vec3::Zero(), rotation};
  return {Vec3(-box.centre().x(), -box.min.y(), -box.centre().z()), rotation};
}

}  // namespace resect
