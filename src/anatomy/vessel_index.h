// Finds the vessel segments near a point.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "anatomy/anatomy.h"

namespace resect {

// A grid of bins over the bounding box of all segments. Each bin lists the segments whose bounding
// box, enlarged by their radius, meets the bin.
class VesselIndex {
 public:
  VesselIndex() = default;
  explicit VesselIndex(std::span<const VesselSegment> segments);

  // Overwrites `found` with the indices of the segments that may meet the box: ascending, each
  // index once. The memory of `found` is reused.
  void near(const Aabb& box, std::vector<std::int32_t>& found) const;
  std::size_t bytes() const {
    return first_.capacity() * sizeof(std::int32_t) + listed_.capacity() * sizeof(std::int32_t);
  }

 private:
  template <typename Visit>
  void visitBins(const Aabb& box, Visit visit) const;

  Aabb box_;
  Vec3i dims_ = Vec3i::Zero();
  // Bin b lists the segments listed_[i] with first_[b] <= i < first_[b + 1].
  std::vector<std::int32_t> first_, listed_;
};

}  // namespace resect
