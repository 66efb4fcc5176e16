#include "geometry/primitives.h"

#include <cmath>
#include <numbers>

#include "base/elementary.h"

namespace resect {

TriangleMesh boxMesh(const Aabb& box) {
  TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner) mesh.points.push_back(box.corner(corner));
  const int quads[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                           {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (const auto& q : quads) {
    mesh.triangles.push_back({q[0], q[1], q[2]});
    mesh.triangles.push_back({q[0], q[2], q[3]});
  }
  return mesh;
}

TriangleMesh sphereMesh(const Vec3& centre, double radius, int rings) {
  TriangleMesh mesh;
  const int sectors = 2 * rings;
  const double step = std::numbers::pi / rings;
  mesh.points.push_back(centre + Vec3(0, radius, 0));
  for (int i = 1; i < rings; ++i)
    for (int j = 0; j < sectors; ++j)
      mesh.points.push_back(centre + radius * Vec3(math::sin(i * step) * math::sin(j * step),
                                                   math::cos(i * step),
                                                   math::sin(i * step) * math::cos(j * step)));
  mesh.points.push_back(centre - Vec3(0, radius, 0));
  const int south = int(mesh.points.size()) - 1;
  const auto at = [&](int i, int j) { return 1 + (i - 1) * sectors + j % sectors; };
  for (int j = 0; j < sectors; ++j) {
    mesh.triangles.push_back({0, at(1, j), at(1, j + 1)});
    for (int i = 1; i + 1 < rings; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
    mesh.triangles.push_back({at(rings - 1, j), south, at(rings - 1, j + 1)});
  }
  return mesh;
}

TriangleMesh torusMesh(const Vec3& centre, double ring, double tube, int around, int across) {
  TriangleMesh mesh;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double a = 2 * std::numbers::pi * i / around, b = 2 * std::numbers::pi * j / across;
      const double r = ring + tube * math::cos(b);
      mesh.points.push_back(centre + Vec3(r * math::sin(a), tube * math::sin(b), r * math::cos(a)));
    }
  const auto at = [&](int i, int j) { return (i % around) * across + j % across; };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

}  // namespace resect
