#include "anatomy/vessel_index.h"

#include <cmath>

namespace resect {
namespace {

constexpr double kBin = 0.006;  // m

Aabb boxOf(const VesselSegment& s) {
  Aabb box;
  box.grow(s.start);
  box.grow(s.end);
  return box.padded(s.radius);
}

}  // namespace

template <typename Visit>
void VesselIndex::visitBins(const Aabb& box, Visit visit) const {
  Vec3i low, high;
  for (int a = 0; a < 3; ++a) {
    const double last = dims_[a] - 1;
    low[a] = int(std::clamp(std::floor((box.min[a] - box_.min[a]) / kBin), 0.0, last));
    high[a] = int(std::clamp(std::floor((box.max[a] - box_.min[a]) / kBin), 0.0, last));
  }
  for (int z = low.z(); z <= high.z(); ++z)
    for (int y = low.y(); y <= high.y(); ++y)
      for (int x = low.x(); x <= high.x(); ++x)
        visit(std::size_t((z * dims_.y() + y) * dims_.x() + x));
}

VesselIndex::VesselIndex(std::span<const VesselSegment> segments) {
  for (const VesselSegment& s : segments) box_.grow(boxOf(s));
  if (box_.empty()) return;
  for (int a = 0; a < 3; ++a) dims_[a] = int(box_.size()[a] / kBin) + 1;
  first_.assign(std::size_t(dims_.prod()) + 1, 0);
  for (const VesselSegment& s : segments)
    visitBins(boxOf(s), [&](std::size_t bin) { ++first_[bin + 1]; });
  for (std::size_t b = 1; b < first_.size(); ++b) first_[b] += first_[b - 1];
  listed_.resize(std::size_t(first_.back()));
  std::vector<std::int32_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < segments.size(); ++i)
    visitBins(boxOf(segments[i]),
              [&](std::size_t bin) { listed_[std::size_t(next[bin]++)] = std::int32_t(i); });
}

void VesselIndex::near(const Aabb& box, std::vector<std::int32_t>& found) const {
  found.clear();
  if (box_.empty() || box.empty() || !meets(box, box_)) return;
  visitBins(box, [&](std::size_t bin) {
    found.insert(found.end(), listed_.begin() + first_[bin], listed_.begin() + first_[bin + 1]);
  });
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
}

}  // namespace resect
