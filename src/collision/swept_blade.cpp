#include "collision/swept_blade.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "geometry/rotation.h"

namespace resect {
namespace {

constexpr double kOnPlane = 1e-12;  // m; rounding of world positions within some metres
constexpr int kMostPlaces = 256;    // of one motion

void addTriangle(SweptBlade& blade, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = b - a, v = c - a;
  const Vec3 cross = u.cross(v);
  const double area2 = cross.squaredNorm(), size = std::max(u.squaredNorm(), v.squaredNorm());
  // Degenerate up to rounding: no segment crosses a line.
  if (!(area2 > 1e-24 * size * size)) return;
  blade.triangles.push_back(
      {a, cross / std::sqrt(area2), v.cross(cross) / area2, cross.cross(u) / area2, b, c});
  for (const Vec3& p : {a, b, c}) blade.bounds.grow(p);
}

void addStrip(SweptBlade& blade, std::span<const Vec3> before, std::span<const Vec3> after) {
  for (std::size_t i = 0; i + 1 < before.size(); ++i) {
    addTriangle(blade, before[i], before[i + 1], after[i + 1]);
    addTriangle(blade, before[i], after[i + 1], after[i]);
  }
}

// Number of steps at which the farthest point of the edge deviates from its chord by at most
// `flatness`.
int stepsOf(std::span<const Vec3> edge, const Pose& from, const Pose& to, double flatness) {
  double reach = 0;
  for (const Vec3& p : edge) reach = std::max(reach, p.norm());
  const double angle = angleBetween(from.rotation, to.rotation);
  // Sagitta of a step: reach (1 - cos(step / 2)) <= reach step^2 / 8.
  const double step = std::sqrt(8 * flatness / std::max(reach, 1e-9));
  return std::clamp(int(std::ceil(angle / step)), 1, kMostPlaces);
}

}  // namespace

SweptBlade sweepBlade(std::span<const Vec3> edge, const Pose& from, const Pose& to,
                      double flatness) {
  require(flatness > 0, "the flatness of a blade's strip is {} m; give a length above 0", flatness);
  SweptBlade blade;
  if (edge.size() < 2) return blade;
  const int steps = stepsOf(edge, from, to, flatness);
  std::vector<Vec3> before(edge.size()), after(edge.size());
  for (std::size_t i = 0; i < edge.size(); ++i) before[i] = from * edge[i];
  for (int step = 1; step <= steps; ++step) {
    const Pose pose = step == steps ? to : interpolate(from, to, double(step) / steps);
    for (std::size_t i = 0; i < edge.size(); ++i) after[i] = pose * edge[i];
    addStrip(blade, before, after);
    before.swap(after);
  }
  return blade;
}

SweptBlade ruledBlade(std::span<const Vec3> before, std::span<const Vec3> after) {
  require(before.size() == after.size(),
          "the edge has {} points before and {} after; give as many of both", before.size(),
          after.size());
  SweptBlade blade;
  addStrip(blade, before, after);
  return blade;
}

void append(SweptBlade& blade, const SweptBlade& more) {
  blade.triangles.insert(blade.triangles.end(), more.triangles.begin(), more.triangles.end());
  blade.bounds.grow(more.bounds);
}

std::optional<BladeCrossing> crossing(const SweptBlade& blade, const Vec3& p, const Vec3& q) {
  std::optional<BladeCrossing> first;
  const Vec3 reach = 2 * kBladeReach * blade.bounds.size() + Vec3::Constant(kOnPlane);
  if ((p.cwiseMax(q).array() < (blade.bounds.min - reach).array()).any() ||
      (p.cwiseMin(q).array() > (blade.bounds.max + reach).array()).any())
    return first;
  for (std::size_t i = 0; i < blade.triangles.size(); ++i) {
    const BladeTriangle& t = blade.triangles[i];
    const double heightP = t.normal.dot(p - t.corner), heightQ = t.normal.dot(q - t.corner);
    if ((heightP >= -kOnPlane) == (heightQ >= -kOnPlane)) continue;
    const double share = std::clamp(heightP / (heightP - heightQ), 0.0, 1.0);
    if (first && first->share <= share) continue;
    const Vec3 x = p + share * (q - p) - t.corner;
    const double u = t.alongU.dot(x), v = t.alongV.dot(x);
    if (u < -kBladeReach || v < -kBladeReach || u + v > 1 + kBladeReach) continue;
    first = BladeCrossing{share, std::int32_t(i)};
  }
  return first;
}

}  // namespace resect
