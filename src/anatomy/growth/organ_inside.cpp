#include "anatomy/growth/organ_inside.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/parallel.h"

namespace resect {
namespace {

constexpr double kGrid = 0.0025;       // m: cells of the grid of distances
constexpr double kPlaces = 0.005;      // m: distance of places
constexpr double kLeastDepth = 0.003;  // m

}  // namespace

OrganInside::OrganInside(const TriangleMesh& surface) : distance_(surface, 2 * kPlaces, kGrid) {
  const Aabb box = bounds(surface).padded(0.75 * kPlaces);
  places_.spacing = Vec3::Constant(kPlaces);
  places_.origin = box.min;
  for (int a = 0; a < 3; ++a) places_.dims[a] = int(std::ceil(box.size()[a] / kPlaces)) + 1;
  depths_.resize(std::size_t(places_.cellCount()));
  parallelFor(depths_.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      depths_[i] = depth(places_.centre(places_.cell(std::int64_t(i))));
  });
  require(!depths_.empty() && *std::ranges::max_element(depths_) >= kLeastDepth,
          "no place in this organ is {:.0f} mm deep, too little for vessels; check its unit",
          1e3 * kLeastDepth);
}

bool OrganInside::deep(const Vec3& a, const Vec3& b, double depth) const {
  const int steps = std::max(1, int(std::ceil((b - a).norm() / kGrid)));
  for (int i = 0; i <= steps; ++i)
    if (this->depth(a + (b - a) * (double(i) / steps)) < depth) return false;
  return true;
}

Vec3 OrganInside::nearestPlace(const Vec3& p, double depth) const {
  double least = std::numeric_limits<double>::infinity();
  std::int64_t best = std::ranges::max_element(depths_) - depths_.begin();
  for (std::int64_t i = 0; i < places_.cellCount(); ++i) {
    if (depthAt(i) < depth) continue;
    const double d = (places_.centre(places_.cell(i)) - p).squaredNorm();
    if (d < least) least = d, best = i;
  }
  return places_.centre(places_.cell(best));
}

}  // namespace resect
