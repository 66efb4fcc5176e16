#include "geometry/measures.h"

#include <Eigen/Geometry>
#include <cmath>

namespace resect {

double area(const TriangleMesh& mesh) {
  requireTriangles(mesh);
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3& p = mesh.points[a];
    sum += 0.5 * (mesh.points[b] - p).cross(mesh.points[c] - p).norm();
  }
  return sum;
}

double volume(const TriangleMesh& mesh) { return volumeAbout(mesh, Vec3::Zero()); }

double volumeAbout(const TriangleMesh& mesh, const Vec3& tip) {
  requireTriangles(mesh);
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += (mesh.points[a] - tip).dot((mesh.points[b] - tip).cross(mesh.points[c] - tip));
  return sum / 6;
}

Vec3 centroid(const TriangleMesh& mesh) {
  requireTriangles(mesh);
  const Vec3 origin = bounds(mesh).centre();
  double sum = 0;
  Vec3 moment = Vec3::Zero();
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 p = mesh.points[a] - origin, q = mesh.points[b] - origin,
               r = mesh.points[c] - origin;
    const double v = p.dot(q.cross(r));
    sum += v;
    moment += v * 0.25 * (p + q + r);
  }
  return std::abs(sum) > 0 ? Vec3(origin + moment / sum) : origin;
}

}  // namespace resect
