#include "collision/signed_distance.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/error.h"
#include "collision/inside.h"
#include "geometry/point_triangle.h"

namespace resect {
namespace {

constexpr double kMostNodes = 2e6;

}  // namespace

SignedDistance::SignedDistance(const TriangleMesh& mesh, double margin, double cell, double band)
    : box_(bounds(mesh)), cell_(cell) {
  require(margin > 0 && cell > 0 && std::isfinite(margin) && std::isfinite(cell),
          "distances were asked for in cells of {} m, {} m round a mesh; give lengths above 0",
          cell, margin);
  require(band >= 2 * cell, "distances were asked for in a band of {} m; give at least two cells",
          band);
  requireSound(mesh);
  if (mesh.triangles.empty()) return;
  const Aabb region = box_.padded(margin);
  const double nodes = (region.size() / cell_ + Vec3::Constant(2)).prod();
  if (nodes > kMostNodes) cell_ *= math::cbrt(nodes / kMostNodes);
  origin_ = region.min;
  for (int a = 0; a < 3; ++a) dims_[a] = int(std::ceil(region.size()[a] / cell_)) + 1;

  std::vector<std::int32_t> nearest(std::size_t(dims_.cast<double>().prod()), -1);
  std::vector<double> squared(nearest.size(), kFar * kFar);
  const auto consider = [&](const Vec3i& at, std::int32_t triangle) {
    const Triangle& t = mesh.triangles[triangle];
    const double d =
        squaredDistance(node(at), mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
    const std::size_t i = index(at);
    if (d < squared[i]) {
      squared[i] = d;
      nearest[i] = triangle;
    }
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Aabb box;
    for (const std::int32_t p : mesh.triangles[t]) box.grow(mesh.points[p]);
    Vec3i low, high;
    for (int a = 0; a < 3; ++a) {
      low[a] = std::clamp(int(std::ceil((box.min[a] - origin_[a]) / cell_ - 1.5)), 0, dims_[a] - 1);
      high[a] =
          std::clamp(int(std::floor((box.max[a] - origin_[a]) / cell_ + 1.5)), 0, dims_[a] - 1);
    }
    for (int z = low.z(); z <= high.z(); ++z)
      for (int y = low.y(); y <= high.y(); ++y)
        for (int x = low.x(); x <= high.x(); ++x) consider({x, y, z}, std::int32_t(t));
  }
  // Sweeps in both directions along each axis propagate the nearest triangle.
  for (int pass = 0; pass < 2; ++pass)
    for (int direction = -1; direction <= 1; direction += 2) {
      const auto from = [&](int axis) { return direction < 0 ? dims_[axis] - 1 : 0; };
      for (int z = from(2); z >= 0 && z < dims_.z(); z += direction)
        for (int y = from(1); y >= 0 && y < dims_.y(); y += direction)
          for (int x = from(0); x >= 0 && x < dims_.x(); x += direction)
            for (int axis = 0; axis < 3; ++axis) {
              const Vec3i at(x, y, z), before = at - direction * Vec3i::Unit(axis);
              if (before[axis] < 0 || before[axis] >= dims_[axis]) continue;
              const std::int32_t triangle = nearest[index(before)];
              if (squared[index(before)] > band * band) continue;
              if (triangle >= 0 && triangle != nearest[index(at)]) consider(at, triangle);
            }
    }

  std::vector<Vec3> places;  // of the nodes in the band
  places.reserve(nearest.size());
  for (int z = 0; z < dims_.z(); ++z)
    for (int y = 0; y < dims_.y(); ++y)
      for (int x = 0; x < dims_.x(); ++x)
        if (squared[index({x, y, z})] <= band * band) places.push_back(node({x, y, z}));
  const std::vector<std::uint8_t> inside = insideFlags(mesh, places);
  distance_.resize(nearest.size());
  // Beyond the band no face lies between a node and the one before it, so they are on one side. The
  // first node is outside.
  const std::size_t before[] = {1, std::size_t(dims_.x()), std::size_t(dims_.x()) * dims_.y()};
  std::size_t next = 0;
  for (int z = 0; z < dims_.z(); ++z)
    for (int y = 0; y < dims_.y(); ++y)
      for (int x = 0; x < dims_.x(); ++x) {
        const std::size_t i = index({x, y, z});
        if (squared[i] <= band * band)
          distance_[i] = float((inside[next++] ? -1 : 1) * std::sqrt(squared[i]));
        else if (i == 0)
          distance_[i] = float(band);
        else
          distance_[i] = float(std::copysign(band, distance_[i - (x > 0   ? before[0]
                                                                  : y > 0 ? before[1]
                                                                          : before[2])]));
      }
}

SignedDistance::Sample SignedDistance::operator()(const Vec3& point) const {
  const Vec3 inCells = (point - origin_) / cell_;
  for (int a = 0; a < 3; ++a)
    if (!(inCells[a] >= 0 && inCells[a] < dims_[a] - 1)) return {kFar, Vec3::Zero()};
  const Vec3i at = inCells.cast<int>();
  const Vec3 f = inCells - at.cast<double>();
  const std::size_t i = index(at), dy = dims_.x(), dz = std::size_t(dims_.x()) * dims_.y();
  const auto along = [&](std::size_t k) {
    return distance_[k] + f.x() * (double(distance_[k + 1]) - distance_[k]);
  };
  const auto slope = [&](std::size_t k) { return double(distance_[k + 1]) - distance_[k]; };
  const double d00 = along(i), d10 = along(i + dy), d01 = along(i + dz), d11 = along(i + dy + dz);
  const double d0 = d00 + f.y() * (d10 - d00), d1 = d01 + f.y() * (d11 - d01);
  const double gx = (1 - f.z()) * ((1 - f.y()) * slope(i) + f.y() * slope(i + dy)) +
                    f.z() * ((1 - f.y()) * slope(i + dz) + f.y() * slope(i + dy + dz));
  const double gy = (1 - f.z()) * (d10 - d00) + f.z() * (d11 - d01);
  const Vec3 gradient(gx, gy, d1 - d0);
  const double size = gradient.norm();
  return {d0 + f.z() * (d1 - d0), size > 1e-12 ? Vec3(gradient / size) : Vec3(Vec3::Zero())};
}

}  // namespace resect
