#include "organ/skin/touch_surface.h"

#include <algorithm>

namespace resect {
namespace {

constexpr float kMiddleIso = 50;
constexpr int kFar = 2;  // cells along each axis

// The particle nearest to a point; -1 if there is none near.
std::int64_t nearestParticle(const Organ& organ, const Vec3& point) {
  const Lattice& lattice = organ.rest.lattice;
  const Vec3 at = lattice.toCellSpace(point);
  const Vec3i middle = at.array().round().cast<int>();
  std::int64_t nearest = -1;
  double least = 1e9;
  for (int dz = -kFar; dz <= kFar; ++dz)
    for (int dy = -kFar; dy <= kFar; ++dy)
      for (int dx = -kFar; dx <= kFar; ++dx) {
        const Vec3i cell = middle + Vec3i(dx, dy, dz);
        if (!lattice.contains(cell) || !organ.rest.inside[std::size_t(lattice.index(cell))])
          continue;
        const double distance = (at - cell.cast<double>()).squaredNorm();
        if (distance >= least) continue;
        least = distance;
        nearest = lattice.index(cell);
      }
  return nearest;
}

}  // namespace

std::vector<SurfacePatch> touchSurface(const Organ& organ) {
  const TriangleMesh mesh = organ.iso == kMiddleIso
                                ? organ.surface.mesh()
                                : SurfaceTracker(organ.field, kMiddleIso).mesh();
  std::vector<SurfacePatch> patches;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.points[std::size_t(t[0])], &b = mesh.points[std::size_t(t[1])],
               &c = mesh.points[std::size_t(t[2])];
    const Vec3 middle = (a + b + c) / 3;
    if (const std::int64_t cell = nearestParticle(organ, middle); cell >= 0)
      patches.push_back({cell, middle.cast<float>(), (0.5 * (b - a).cross(c - a)).cast<float>()});
  }
  std::ranges::stable_sort(patches, {}, &SurfacePatch::cell);
  return patches;
}

}  // namespace resect
