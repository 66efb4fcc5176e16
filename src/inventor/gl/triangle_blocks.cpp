#include "inventor/gl/triangle_blocks.h"

#include <algorithm>
#include <limits>

namespace resect {

TriangleBlocks::Box TriangleBlocks::emptyBox() {
  const Vec3f far = Vec3f::Constant(std::numeric_limits<float>::infinity());
  return {far, -far};
}

void TriangleBlocks::refresh(std::span<const Vec3f> points, std::span<const Triangle> triangles) {
  blocks_.resize((triangles.size() + kTriangles - 1) / kTriangles);
  for (const Range& r : triangles_) {
    const std::size_t end = std::min(blocks_.size(), (r.end + kTriangles - 1) / kTriangles);
    for (std::size_t b = r.begin / kTriangles; b < end; ++b) blocks_[b].stale = true;
  }
  for (const Range& r : vertices_)
    for (Block& block : blocks_)
      if (std::size_t(block.low) < r.end && block.high >= std::int32_t(r.begin)) block.stale = true;
  triangles_.clear();
  vertices_.clear();
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (!blocks_[b].stale) continue;
    Block block{emptyBox(), std::numeric_limits<std::int32_t>::max(), -1, false};
    const std::size_t first = b * kTriangles;
    for (const Triangle& t :
         triangles.subspan(first, std::min(kTriangles, triangles.size() - first))) {
      if (t[0] == t[1]) continue;
      for (const std::int32_t v : t) {
        if (std::size_t(v) >= points.size()) continue;  // vertices not set yet
        block.box.grow(points[std::size_t(v)]);
        block.low = std::min(block.low, v);
        block.high = std::max(block.high, v);
      }
    }
    blocks_[b] = block;
  }
}

TriangleBlocks::Box TriangleBlocks::around(std::size_t begin, std::size_t end,
                                           std::span<const Vec3f> points,
                                           std::span<const Triangle> triangles) const {
  Box all = emptyBox();
  const auto uses = [&](std::int32_t v) { return std::size_t(v) >= begin && std::size_t(v) < end; };
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (std::int64_t(blocks_[b].low) >= std::int64_t(end) ||
        std::int64_t(blocks_[b].high) < std::int64_t(begin))
      continue;
    const std::size_t first = b * kTriangles;
    for (const Triangle& t :
         triangles.subspan(first, std::min(kTriangles, triangles.size() - first)))
      if (t[0] != t[1] && std::ranges::any_of(t, uses))
        for (const std::int32_t v : t) all.grow(points[std::size_t(v)]);
  }
  return all;
}

TriangleBlocks::Box TriangleBlocks::box() const {
  Box all = emptyBox();
  for (const Block& block : blocks_) {
    all.low = all.low.cwiseMin(block.box.low);
    all.high = all.high.cwiseMax(block.box.high);
  }
  return all;
}

// Runs of the triangles of non-empty blocks for which wanted(box) is true.
template <typename Wanted>
std::vector<TriangleBlocks::Run> TriangleBlocks::runsOf(Wanted wanted) const {
  std::vector<Run> runs;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (blocks_[b].high < 0 || !wanted(blocks_[b].box)) continue;
    const std::size_t first = b * kTriangles;
    if (!runs.empty() && runs.back().first + runs.back().count == first)
      runs.back().count += kTriangles;
    else
      runs.push_back({first, kTriangles});
  }
  return runs;
}

std::vector<TriangleBlocks::Run> TriangleBlocks::within(const HalfSpaces& spaces) const {
  // Tests the corner of the box that is farthest inside each half space.
  return runsOf([&](const Box& box) {
    return std::ranges::all_of(spaces, [&](const Eigen::Vector4f& s) {
      const Vec3f corner = (s.head<3>().array() > 0).select(box.high, box.low);
      return corner.dot(s.head<3>()) + s[3] >= 0;
    });
  });
}

std::vector<TriangleBlocks::Run> TriangleBlocks::along(const Ray& ray) const {
  return runsOf([&](const Box& box) {
    // Slightly enlarged against rounding of triangles in its sides.
    const double margin = 1e-6 * double((box.high - box.low).maxCoeff());
    return meets(ray, Aabb{box.low.cast<double>(), box.high.cast<double>()}.padded(margin));
  });
}

TriangleBlocks::HalfSpaces halfSpacesOf(const float matrix[4][4], const Eigen::Vector2f& low,
                                        const Eigen::Vector2f& high) {
  const auto column = [&](int c) {
    return Eigen::Vector4f(matrix[0][c], matrix[1][c], matrix[2][c], matrix[3][c]);
  };
  const Eigen::Vector4f x = column(0), y = column(1), z = column(2), w = column(3);
  return {x - low.x() * w, high.x() * w - x, y - low.y() * w, high.y() * w - y, z + w, w - z};
}

}  // namespace resect
