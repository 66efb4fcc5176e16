#include "sph/particle_sums.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "sph/kernel.h"

namespace resect {

ParticleSums::ParticleSums(std::span<const Vec3> positions, std::span<const double> volumes,
                           double h)
    : h_(h), box_(bounds(positions)) {
  require(positions.size() == volumes.size(),
          "there are {} positions and {} volumes; give a volume for each particle",
          positions.size(), volumes.size());
  require(h > 0 && std::isfinite(h), "the smoothing length is {} m; give one above 0", h);
  require(std::ranges::all_of(positions, [](const Vec3& p) { return p.allFinite(); }),
          "the position of a particle is not finite; give numbers");
  if (positions.empty()) box_ = {Vec3::Zero(), Vec3::Zero()};
  const double cell = kKernelSupport * h;
  // A cell is at least as wide as the kernel's radius; wider if the box would need too many cells.
  for (int a = 0; a < 3; ++a)
    dims_[a] = int(std::clamp(std::floor(box_.size()[a] / cell), 1.0, 256.0));
  const auto cellOf = [&](const Vec3& p) {
    std::int64_t index = 0;
    for (int a = 2; a >= 0; --a) {
      const double width = std::max(box_.size()[a] / dims_[a], 1e-300);
      const int i = std::clamp(int((p[a] - box_.min[a]) / width), 0, dims_[a] - 1);
      index = index * dims_[a] + i;
    }
    return index;
  };
  cellStart_.assign(std::size_t(dims_.prod()) + 1, 0);
  for (const Vec3& p : positions) ++cellStart_[cellOf(p) + 1];
  for (std::size_t i = 1; i < cellStart_.size(); ++i) cellStart_[i] += cellStart_[i - 1];
  std::vector<std::int32_t> next(cellStart_.begin(), cellStart_.end() - 1);
  index_.resize(positions.size());
  position_.resize(positions.size());
  volume_.resize(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const std::int32_t slot = next[cellOf(positions[i])]++;
    index_[slot] = std::int32_t(i);
    position_[slot] = positions[i];
    volume_[slot] = volumes[i];
  }
}

// visit(i, W) for every particle i in reach of r, by its sorted index, in the grid's fixed order.
template <typename Visit>
void ParticleSums::visitNeighbours(const Vec3& r, Visit visit) const {
  const double support = kKernelSupport * h_;
  Vec3i low, high;
  for (int a = 0; a < 3; ++a) {
    const double width = std::max(box_.size()[a] / dims_[a], 1e-300);
    const double first = std::floor((r[a] - support - box_.min[a]) / width);
    const double last = std::floor((r[a] + support - box_.min[a]) / width);
    if (last < 0 || first > dims_[a]) return;
    low[a] = int(std::clamp(first, 0.0, double(dims_[a] - 1)));
    high[a] = int(std::clamp(last, 0.0, double(dims_[a] - 1)));
  }
  for (int z = low.z(); z <= high.z(); ++z)
    for (int y = low.y(); y <= high.y(); ++y) {
      const std::int64_t row = (std::int64_t(z) * dims_.y() + y) * dims_.x();
      for (std::int32_t i = cellStart_[row + low.x()]; i < cellStart_[row + high.x() + 1]; ++i) {
        const double distance = (r - position_[i]).norm();
        if (distance < support) visit(i, kernel(distance, h_));
      }
    }
}

double ParticleSums::interpolate(std::span<const double> attribute, const Vec3& r) const {
  require(attribute.size() == position_.size(),
          "there are {} values for {} particles; give one for each", attribute.size(),
          position_.size());
  double sum = 0;
  visitNeighbours(
      r, [&](std::int32_t slot, double w) { sum += volume_[slot] * attribute[index_[slot]] * w; });
  return sum;
}

double ParticleSums::partitionOfUnity(const Vec3& r) const {
  double sum = 0;
  visitNeighbours(r, [&](std::int32_t slot, double w) { sum += volume_[slot] * w; });
  return sum;
}

double ParticleSums::density(std::span<const double> mass, const Vec3& r) const {
  require(mass.size() == position_.size(),
          "there are {} masses for {} particles; give one for each", mass.size(), position_.size());
  double sum = 0;
  visitNeighbours(r, [&](std::int32_t slot, double w) { sum += mass[index_[slot]] * w; });
  return sum;
}

}  // namespace resect
