#include "geometry/repair/crossings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace resect {
namespace {

// Whether the edge crosses the half-line from p along +Y, seen along X: +1 upwards in Z, -1
// downwards, 0 not.
int crossing(const Vec3& from, const Vec3& to, const Vec3& p) {
  const bool fromAbove = from.z() > p.z(), toAbove = to.z() > p.z();
  if (fromAbove == toAbove) return 0;
  // Always from the lower to the upper end, so that both neighbours of the edge get the same
  // rounding.
  const Vec3& low = fromAbove ? to : from;
  const Vec3& high = fromAbove ? from : to;
  const bool right =
      (high.y() - low.y()) * (p.z() - low.z()) > (high.z() - low.z()) * (p.y() - low.y());
  return right ? (toAbove ? 1 : -1) : 0;
}

// The triangles that overlap each of a number of slabs of equal thickness.
class Slabs {
 public:
  explicit Slabs(const TriangleMesh& mesh) {
    const Aabb box = bounds(mesh);
    const double count = std::ceil(std::sqrt(double(mesh.triangles.size())));
    low_ = box.min.z();
    perMetre_ = box.size().z() > 0 ? count / box.size().z() : 0;
    first_.assign(std::size_t(count) + 2, 0);
    const auto forEach = [&](auto&& visit) {
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const auto [least, most] =
            std::minmax({mesh.points[a].z(), mesh.points[b].z(), mesh.points[c].z()});
        for (std::size_t s = slabOf(least); s <= slabOf(most); ++s) visit(s, std::int32_t(t));
      }
    };
    forEach([&](std::size_t s, std::int32_t) { ++first_[s + 1]; });
    for (std::size_t s = 1; s < first_.size(); ++s) first_[s] += first_[s - 1];
    triangles_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    forEach([&](std::size_t s, std::int32_t t) { triangles_[next[s]++] = t; });
  }

  std::span<const std::int32_t> at(double z) const {
    const std::size_t s = slabOf(z);
    return {triangles_.data() + first_[s], first_[s + 1] - first_[s]};
  }

 private:
  std::size_t slabOf(double z) const {
    const auto last = double(first_.size() - 2);
    return std::size_t(std::clamp((z - low_) * perMetre_, 0.0, last));
  }

  double low_, perMetre_;
  std::vector<std::size_t> first_;  // per slab, into triangles_; one more than slabs
  std::vector<std::int32_t> triangles_;
};

}  // namespace

std::vector<int> crossingNumbers(const TriangleMesh& mesh, std::span<const Vec3> points) {
  requireTriangles(mesh);
  std::vector<int> numbers(points.size(), 0);
  if (points.empty() || mesh.triangles.empty()) return numbers;
  const Slabs slabs(mesh);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3& p = points[i];
    for (const std::int32_t t : slabs.at(p.z())) {
      const Vec3 &a = mesh.points[mesh.triangles[t][0]], &b = mesh.points[mesh.triangles[t][1]],
                 &c = mesh.points[mesh.triangles[t][2]];
      const int round = crossing(a, b, p) + crossing(b, c, p) + crossing(c, a, p);
      if (round != 0 && (b - a).cross(c - a).dot(a - p) * round > 0) numbers[i] += round;
    }
  }
  return numbers;
}

}  // namespace resect
