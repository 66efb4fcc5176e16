#include "geometry/triangle_mesh.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "base/error.h"
#include "base/parallel.h"

namespace resect {

Aabb bounds(const TriangleMesh& mesh) { return bounds(std::span<const Vec3>(mesh.points)); }

namespace {
constexpr std::size_t kGrain = 1 << 14;
}

void requireTriangles(const TriangleMesh& mesh) {
  std::atomic<bool> known = true;
  parallelFor(mesh.triangles.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    std::uint32_t most = 0;  // a negative number is a large one
    for (std::size_t t = begin; t < end; ++t)
      for (const std::int32_t p : mesh.triangles[t]) most = std::max(most, std::uint32_t(p));
    if (most >= mesh.points.size()) known = false;
  });
  require(known, "a triangle of the mesh uses a point beyond its {}; correct its indices",
          mesh.points.size());
}

void requireSound(const TriangleMesh& mesh) {
  requireTriangles(mesh);
  std::atomic<bool> finite = true;
  parallelFor(mesh.points.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    bool all = true;
    for (std::size_t i = begin; i < end; ++i) all &= mesh.points[i].allFinite();
    if (!all) finite = false;
  });
  require(finite, "a point of the mesh is not finite; give numbers");
}

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
