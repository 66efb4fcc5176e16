#include "inventor/gl/surface_ray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace resect {

std::optional<OrganPoint> firstPointOn(const SurfaceCopy& surface, const TriangleBlocks& blocks,
                                       const Ray& ray) {
  const auto corner = [&](std::int32_t v) -> Vec3 {
    return surface.points[std::size_t(v)].cast<double>();
  };
  double first = std::numeric_limits<double>::infinity();
  const Triangle* met = nullptr;
  for (const TriangleBlocks::Run& run : blocks.along(ray)) {
    const std::size_t end = std::min(run.first + run.count, surface.triangles.size());
    for (std::size_t i = run.first; i < end; ++i) {
      const Triangle& t = surface.triangles[i];
      if (t[0] == t[1]) continue;  // unused
      const double here = firstMeeting(ray, corner(t[0]), corner(t[1]), corner(t[2]));
      if (here < first) first = here, met = &t;
    }
  }
  if (!met) return std::nullopt;
  // The mean of the corners' normals changes little from one triangle to the next.
  Vec3 normal = Vec3::Zero();
  double cut = 0;
  for (const std::int32_t v : *met) {
    normal += surface.normals[std::size_t(v)].cast<double>();
    cut += std::max(0.0, double(surface.cut[std::size_t(v)])) / 3;
  }
  constexpr double kSmall = 1e-6;
  if (normal.norm() < kSmall) normal = -ray.direction;
  return OrganPoint{{ray.at(first), normal.normalized()}, cut};
}

}  // namespace resect
