#include "collision/inside_query.h"

#include <algorithm>
#include <utility>

#include "collision/footprint.h"

namespace resect {

InsideQuery::InsideQuery(std::shared_ptr<const TriangleMesh> mesh, const Aabb& region)
    : mesh_(std::move(mesh)), snapped_(snapToRaster(*mesh_)) {
  region_ = intersection(region, bounds(*mesh_));
  if (region_.empty()) return;
  originX_ = snapColumn(region_.min.x() - snapped_.origin.x(), snapped_.step);
  originY_ = snapColumn(region_.min.y() - snapped_.origin.y(), snapped_.step);
  const std::int32_t endX = snapColumn(region_.max.x() - snapped_.origin.x(), snapped_.step);
  const std::int32_t endY = snapColumn(region_.max.y() - snapped_.origin.y(), snapped_.step);

  // Triangles whose box meets the region, seen along z; what lies above it is below no point of it.
  struct Kept {
    std::uint32_t triangle;
    std::int32_t lowX, highX, lowY, highY;
  };
  std::vector<Kept> kept;
  for (std::size_t t = 0; t < mesh_->triangles.size(); ++t) {
    const auto& [ia, ib, ic] = mesh_->triangles[t];
    const auto a = snapped_.point(ia), b = snapped_.point(ib), c = snapped_.point(ic);
    const auto [lowX, highX] = std::minmax({a.x, b.x, c.x});
    const auto [lowY, highY] = std::minmax({a.y, b.y, c.y});
    if (lowX == highX || lowY == highY || lowX > endX || highX < originX_ || lowY > endY ||
        highY < originY_ || std::min({a.z, b.z, c.z}) >= region_.max.z())
      continue;
    kept.push_back({std::uint32_t(t), lowX, highX, lowY, highY});
  }
  side_ = int(std::clamp(std::sqrt(double(kept.size())), 1.0, 256.0));
  width_ = (std::int64_t(endX) - originX_) / side_ + 1;
  height_ = (std::int64_t(endY) - originY_) / side_ + 1;
  offsets_.assign(std::size_t(side_) * side_ + 1, 0);
  const auto forEachCell = [&](const Kept& k, auto&& visit) {
    for (int j = cellY(k.lowY); j <= cellY(k.highY); ++j)
      for (int i = cellX(k.lowX); i <= cellX(k.highX); ++i) visit(std::size_t(j) * side_ + i);
  };
  for (const Kept& k : kept) forEachCell(k, [&](std::size_t cell) { ++offsets_[cell + 1]; });
  for (std::size_t c = 1; c < offsets_.size(); ++c) offsets_[c] += offsets_[c - 1];
  triangles_.resize(offsets_.back());
  std::vector<std::uint32_t> cursor(offsets_.begin(), offsets_.end() - 1);
  for (const Kept& k : kept)
    forEachCell(k, [&](std::size_t cell) { triangles_[cursor[cell]++] = k.triangle; });
}

int InsideQuery::cellX(std::int32_t x) const {
  return int(std::clamp<std::int64_t>((std::int64_t(x) - originX_) / width_, 0, side_ - 1));
}

int InsideQuery::cellY(std::int32_t y) const {
  return int(std::clamp<std::int64_t>((std::int64_t(y) - originY_) / height_, 0, side_ - 1));
}

bool InsideQuery::isInside(const Vec3& p) const {
  if (!region_.contains(p)) return false;
  const std::int32_t x = snapColumn(p.x() - snapped_.origin.x(), snapped_.step);
  const std::int32_t y = snapColumn(p.y() - snapped_.origin.y(), snapped_.step);
  const std::size_t cell = std::size_t(cellY(y)) * side_ + cellX(x);
  int winding = 0;
  for (std::uint32_t n = offsets_[cell]; n < offsets_[cell + 1]; ++n) {
    const auto& [a, b, c] = mesh_->triangles[triangles_[n]];
    const Footprint footprint(snapped_.point(a), snapped_.point(b), snapped_.point(c));
    if (!footprint.empty())
      footprint.test(x, y, [&](double depth) { winding += depth < p.z() ? footprint.sign() : 0; });
  }
  return winding > 0;
}

}  // namespace resect
