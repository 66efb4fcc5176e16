#include "geometry/triangle_mesh.h"

#include <utility>

namespace resect {

Aabb bounds(const TriangleMesh& mesh) { return bounds(std::span<const Vec3>(mesh.points)); }

TriangleMesh transformed(TriangleMesh mesh, const Pose& pose) {
  for (Vec3& p : mesh.points) p = pose * p;
  return mesh;
}

void append(TriangleMesh& a, const TriangleMesh& b) {
  const auto base = std::int32_t(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  a.triangles.reserve(a.triangles.size() + b.triangles.size());
  for (const Triangle& t : b.triangles)
    a.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
}

void flip(TriangleMesh& mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
}

}  // namespace resect
