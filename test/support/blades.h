// Blades for tests: curved patches as strips of triangles, in rest space.
#pragma once

#include <Eigen/Geometry>
#include <functional>

#include "base/random.h"
#include "collision/swept_blade.h"
#include "support/block_organ.h"
#include "wound/blade_raster.h"

namespace resect::test {

inline void addBladeTriangle(SweptBlade& blade, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = b - a, v = c - a, cross = u.cross(v);
  const double area2 = cross.squaredNorm();
  if (!(area2 > 0)) return;
  blade.triangles.push_back(
      {a, cross / std::sqrt(area2), v.cross(cross) / area2, cross.cross(u) / area2, b, c});
  for (const Vec3& p : {a, b, c}) blade.bounds.grow(p);
}

// The patch at(u, v), u and v in [0, 1], as 2 nu nv triangles; v grows while the blade advances.
inline SweptBlade patch(const std::function<Vec3(double, double)>& at, int nu, int nv) {
  SweptBlade blade;
  for (int j = 0; j < nv; ++j)
    for (int i = 0; i < nu; ++i) {
      const auto p = [&](int di, int dj) { return at(double(i + di) / nu, double(j + dj) / nv); };
      addBladeTriangle(blade, p(0, 0), p(1, 0), p(1, 1));
      addBladeTriangle(blade, p(0, 0), p(1, 1), p(0, 1));
    }
  return blade;
}

// A flat piece centre + (2 u - 1) a + (2 v - 1) b.
inline SweptBlade flatBlade(const Vec3& centre, const Vec3& a, const Vec3& b, int nu = 1,
                            int nv = 1) {
  return patch([&](double u, double v) { return Vec3(centre + (2 * u - 1) * a + (2 * v - 1) * b); },
               nu, nv);
}

inline void append(SweptBlade& blade, const SweptBlade& more) {
  blade.triangles.insert(blade.triangles.end(), more.triangles.begin(), more.triangles.end());
  blade.bounds.grow(more.bounds);
}

inline Vec3 randomDirection(Random& random) {
  Vec3 d;
  do d = Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  while (d.norm() > 1 || d.norm() < 0.1);
  return d.normalized();
}

// A bent piece of blade of half-widths 0.2 to 1.2 `size`, somewhere within `size` of the middle;
// now and then one that lies in a plane of nodes exactly.
inline SweptBlade randomBlade(const Vec3& middle, double size, double spacing, Random& random) {
  Vec3 normal = randomDirection(random);
  Vec3 centre = middle + size * random.uniform() * randomDirection(random);
  double bend = random.uniform(-0.5, 0.5) * size;
  if (random.below(5) == 0) {
    normal = Vec3::Unit(random.below(3));
    centre = middle + ((centre - middle) / spacing).array().round().matrix() * spacing;
    bend = 0;
  }
  const Vec3 a = normal.unitOrthogonal(), b = normal.cross(a);
  const double wide = size * random.uniform(0.2, 1.2), deep = size * random.uniform(0.2, 1.2);
  return patch(
      [&](double u, double v) {
        const double s = 2 * u - 1, t = 2 * v - 1;
        return Vec3(centre + s * wide * a + t * deep * b + bend * (s * s + 0.5 * s * t) * normal);
      },
      4, 4);
}

// A lumpy ball of tissue that fills `cells` cells a side but two.
inline Discretization blob(int cells, double s = 0.005) {
  const Vec3 middle = Vec3::Constant(0.5 * (cells - 1));
  return fill(Vec3i::Constant(cells), s, [&](const Vec3i& c) {
    const Vec3 d = c.cast<double>() - middle;
    const double lumps = std::sin(9.0 / cells * d.x() + 1) * std::sin(8.0 / cells * d.y()) +
                         0.5 * std::sin(11.0 / cells * d.z());
    const double radius = 0.5 * cells * (0.82 + 0.1 * lumps);
    return 100 * std::clamp(radius - d.norm() + 0.5, 0.0, 1.0);
  });
}

}  // namespace resect::test
