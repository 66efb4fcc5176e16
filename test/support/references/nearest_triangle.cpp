#include "support/references/nearest_triangle.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "support/references/mesh_reference.h"

namespace resect::test {
namespace {

Vec3 areaVector(const TriangleMesh& mesh, const Triangle& t) {
  const Vec3& p = mesh.points[t[0]];
  return 0.5 * (mesh.points[t[1]] - p).cross(mesh.points[t[2]] - p);
}

double degreesBetween(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

}  // namespace

NearestTriangle::NearestTriangle(const TriangleMesh& mesh, double cell)
    : mesh_(mesh), cell_(cell), box_(bounds(mesh.points)) {
  dims_ = (box_.size() / cell).cast<int>() + Vec3i::Ones();
  triangles_.resize(std::size_t(dims_.x()) * dims_.y() * dims_.z());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Aabb box;
    for (const std::int32_t p : mesh.triangles[t]) box.grow(mesh.points[p]);
    const Vec3i low = cellOf(box.min), high = cellOf(box.max);
    for (int z = low.z(); z <= high.z(); ++z)
      for (int y = low.y(); y <= high.y(); ++y)
        for (int x = low.x(); x <= high.x(); ++x)
          triangles_[(std::size_t(z) * dims_.y() + y) * dims_.x() + x].push_back(std::int32_t(t));
  }
}

Vec3i NearestTriangle::cellOf(const Vec3& point) const {
  const Vec3 cell = ((point - box_.min) / cell_).array().floor();
  return cell.cwiseMax(0.0).cwiseMin((dims_ - Vec3i::Ones()).cast<double>()).cast<int>();
}

NearestTriangle::Result NearestTriangle::operator()(const Vec3& point) const {
  Result best{std::numeric_limits<double>::infinity(), -1};
  const Vec3i centre = cellOf(point);
  for (int ring = 0; ring <= dims_.maxCoeff(); ++ring) {
    // What no ring before this one holds is at least ring - 1 cells away from the point's place in
    // the box, and not nearer to the point itself.
    if (best.distance < (ring - 1) * cell_) break;
    const Vec3i low = (centre - Vec3i::Constant(ring)).cwiseMax(0);
    const Vec3i high = (centre + Vec3i::Constant(ring)).cwiseMin(dims_ - Vec3i::Ones());
    for (int z = low.z(); z <= high.z(); ++z)
      for (int y = low.y(); y <= high.y(); ++y)
        for (int x = low.x(); x <= high.x(); ++x) {
          if ((Vec3i(x, y, z) - centre).cwiseAbs().maxCoeff() != ring) continue;
          for (const std::int32_t t :
               triangles_[(std::size_t(z) * dims_.y() + y) * dims_.x() + x]) {
            const auto& [a, b, c] = mesh_.triangles[t];
            const double distance =
                distanceToTriangle(point, mesh_.points[a], mesh_.points[b], mesh_.points[c]);
            if (distance < best.distance || (distance == best.distance && t < best.triangle))
              best = {distance, t};
          }
        }
  }
  return best;
}

Deviation deviation(const TriangleMesh& surface, const std::vector<Vec3f>& normals,
                    const TriangleMesh& original) {
  double originalArea = 0;
  for (const Triangle& t : original.triangles) originalArea += areaVector(original, t).norm();
  const NearestTriangle nearest(original,
                                std::sqrt(2 * originalArea / double(original.triangles.size())));
  const auto normalAt = [&](const NearestTriangle::Result& r) {
    return areaVector(original, original.triangles[r.triangle]);
  };
  std::vector<double> shading;
  for (std::size_t i = 0; i < surface.points.size(); ++i)
    shading.push_back(
        degreesBetween(normalAt(nearest(surface.points[i])), normals[i].cast<double>()));
  Deviation sum;
  double total = 0;
  for (const Triangle& t : surface.triangles) {
    const Vec3 normal = areaVector(surface, t);
    const double size = normal.norm();
    const NearestTriangle::Result r =
        nearest((surface.points[t[0]] + surface.points[t[1]] + surface.points[t[2]]) / 3);
    sum.distance += size * r.distance;
    sum.faceAngle += size * degreesBetween(normal, normalAt(r));
    sum.shadingAngle += size * (shading[t[0]] + shading[t[1]] + shading[t[2]]) / 3;
    total += size;
  }
  return {sum.distance / total, sum.faceAngle / total, sum.shadingAngle / total};
}

}  // namespace resect::test
