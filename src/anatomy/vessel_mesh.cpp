#include "anatomy/vessel_mesh.h"

#include <cmath>
#include <numbers>

#include "base/elementary.h"

namespace resect {
namespace {

constexpr int kSides = 8;

void addTube(TriangleMesh& mesh, const VesselSegment& s) {
  const Vec3 along = (s.end - s.start).normalized();
  const Vec3 u = along.cross(std::abs(along.x()) < 0.7 ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitY()))
                     .normalized();
  const Vec3 v = along.cross(u);
  const std::int32_t first = std::int32_t(mesh.points.size());
  // Ends are a little longer, so that no gap opens where segments meet at an angle.
  for (const Vec3& end :
       {Vec3(s.start - 0.4 * s.radius * along), Vec3(s.end + 0.4 * s.radius * along)}) {
    for (int k = 0; k < kSides; ++k) {
      const double angle = 2 * std::numbers::pi * k / kSides;
      mesh.points.push_back(end + s.radius * (math::cos(angle) * u + math::sin(angle) * v));
    }
    mesh.points.push_back(end);
  }
  const auto at = [&](int ring, int k) { return first + ring * (kSides + 1) + k % kSides; };
  for (int k = 0; k < kSides; ++k) {
    mesh.triangles.push_back({at(0, k), at(0, k + 1), at(1, k)});
    mesh.triangles.push_back({at(0, k + 1), at(1, k + 1), at(1, k)});
    mesh.triangles.push_back({at(0, k + 1), at(0, k), first + kSides});
    mesh.triangles.push_back({at(1, k), at(1, k + 1), first + 2 * kSides + 1});
  }
}

}  // namespace

TriangleMesh vesselMesh(const Anatomy& anatomy, VesselKind kind) {
  TriangleMesh mesh;
  const VesselRange range = anatomy.range(kind);
  for (std::int32_t i = range.first; i < range.first + range.count; ++i)
    addTube(mesh, anatomy.segments[std::size_t(i)]);
  return mesh;
}

}  // namespace resect
