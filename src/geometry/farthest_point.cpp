#include "geometry/farthest_point.h"

#include <algorithm>
#include <limits>

#include "base/error.h"

namespace resect {
namespace {

constexpr int kSide = 24;  // cells per axis; those that hold points become clusters

}  // namespace

FarthestPoint::FarthestPoint(std::span<const Vec3> points)
    : points_(points.size()), order_(points.size()) {
  require(!points.empty(), "there is no farthest point of none; give at least one");
  require(std::ranges::all_of(points, [](const Vec3& p) { return p.allFinite(); }),
          "a point is not finite; give numbers");
  Aabb box;
  for (const Vec3& p : points) box.grow(p);
  rounding_ = 1e-14 * (box.min.cwiseAbs() + box.max.cwiseAbs()).sum();
  const Vec3 size = box.size();
  Vec3 perCell = Vec3::Zero();
  for (int a = 0; a < 3; ++a)
    if (size[a] > 0) perCell[a] = kSide / size[a];
  const auto cellOf = [&](const Vec3& p) {
    const Vec3 place = (p - box.min).cwiseProduct(perCell);
    const Vec3i c = place.cwiseMin(kSide - 1).cast<int>();
    return std::size_t((c.z() * kSide + c.y()) * kSide + c.x());
  };
  std::vector<std::uint32_t> next(kSide * kSide * kSide + 1, 0);
  for (const Vec3& p : points) ++next[cellOf(p) + 1];
  for (std::size_t c = 1; c < next.size(); ++c) next[c] += next[c - 1];
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const std::uint32_t place = next[cellOf(points[i])]++;
    order_[place] = i;
    points_[place] = points[i];
  }
  std::uint32_t first = 0;  // afterwards next[c] is where cell c ends
  for (std::size_t c = 0; c + 1 < next.size(); first = next[c++]) {
    if (first == next[c]) continue;
    Cluster cluster{{}, first, next[c]};
    for (std::uint32_t k = first; k < next[c]; ++k) cluster.box.grow(points_[k]);
    clusters_.push_back(cluster);
  }
}

std::uint32_t FarthestPoint::along(const Vec3& direction) const {
  const auto reachOf = [&](const Cluster& c) {
    return direction.cwiseProduct(c.box.min).cwiseMax(direction.cwiseProduct(c.box.max)).sum();
  };
  double reach = -std::numeric_limits<double>::infinity();
  std::uint32_t best = 0;
  const auto lookInto = [&](const Cluster& c) {
    for (std::uint32_t k = c.begin; k < c.end; ++k) {
      const double r = direction.dot(points_[k]);
      if (r > reach || (r == reach && order_[k] < best)) reach = r, best = order_[k];
    }
  };
  // First the cluster whose box reaches farthest: its points rule out nearly all others.
  const Cluster* foremost = &clusters_.front();
  double most = reachOf(*foremost);
  for (const Cluster& c : clusters_)
    if (const double r = reachOf(c); r > most) most = r, foremost = &c;
  lookInto(*foremost);
  const double slack = rounding_ * direction.cwiseAbs().sum();
  for (const Cluster& c : clusters_)
    if (&c != foremost && reachOf(c) >= reach - slack) lookInto(c);
  return best;
}

}  // namespace resect
