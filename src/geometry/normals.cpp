#include "geometry/normals.h"

#include <cmath>

#include "base/elementary.h"

namespace resect {

std::vector<Vec3> pointNormals(const TriangleMesh& mesh) {
  requireTriangles(mesh);
  std::vector<Vec3> normals(mesh.points.size(), Vec3::Zero());
  for (const Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.points[std::size_t(t[0])];
    const Vec3& b = mesh.points[std::size_t(t[1])];
    const Vec3& c = mesh.points[std::size_t(t[2])];
    const Vec3 cross = (b - a).cross(c - a);
    const double doubleArea = cross.norm();
    if (doubleArea == 0.0) continue;
    const Vec3 normal = cross / doubleArea;
    const auto angle = [&](const Vec3& from, const Vec3& p, const Vec3& q) {
      return math::atan2(doubleArea, (p - from).dot(q - from));
    };
    normals[std::size_t(t[0])] += angle(a, b, c) * normal;
    normals[std::size_t(t[1])] += angle(b, c, a) * normal;
    normals[std::size_t(t[2])] += angle(c, a, b) * normal;
  }
  for (Vec3& n : normals) {
    const double length = n.norm();
    n = length > 0.0 ? Vec3(n / length) : Vec3(Vec3::UnitY());
  }
  return normals;
}

}  // namespace resect
