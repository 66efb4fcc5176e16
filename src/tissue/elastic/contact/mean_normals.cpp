#include "tissue/elastic/contact/mean_normals.h"

#include <algorithm>

namespace resect {
namespace {

constexpr int kAround = 3;  // cells, along each axis

// Part of the normal that faces that side of AreaBySide.
float facing(const Vec3f& normal, std::size_t side) {
  const float along = normal[Eigen::Index(side / 2)];
  return std::max(0.0f, side % 2 == 0 ? along : -along);
}

}  // namespace

Vec3 meanNormal(const AreaBySide& around, const Vec3f& normal) {
  Vec3f sum = Vec3f::Zero();
  for (std::size_t side = 0; side < around.size(); ++side) {
    const float part = facing(normal, side);
    sum += part * part * around[side];
  }
  return sum.cast<double>().normalized();
}

void MeanNormals::clear(const ElasticState& s) {
  for (const std::int32_t i : seen_) index_[std::size_t(i)] = kNotSeen;
  index_.resize(std::size_t(s.box.size), kNotSeen);
  seen_.clear();
  sides_.clear();
}

std::int32_t MeanNormals::find(const ElasticState& s, const ContactPoints& points,
                               ChunkGradients& gradients, std::int32_t i) {
  std::int32_t& index = index_[std::size_t(i)];
  if (index != kNotSeen) return index;
  seen_.push_back(i);
  found_.clear();
  if (s.solid[i]) points.fine(s, i, true, found_);
  if (found_.empty()) return index = kNoSurface;
  AreaBySide sides;
  sides.fill(Vec3f::Zero());
  for (const ContactPoint& point : found_)
    for (std::size_t side = 0; side < sides.size(); ++side)
      sides[side] += facing(point.normal, side) * point.area * point.normal;
  const Mat3 turn = cofactors(Mat3::Identity() + gradients.at(i));
  for (Vec3f& side : sides) side = (turn * side.cast<double>()).cast<float>();
  sides_.push_back(sides);
  return index = std::int32_t(sides_.size()) - 1;
}

AreaBySide MeanNormals::around(const ElasticState& s, const ContactPoints& points,
                               ChunkGradients& gradients, std::int32_t cell) {
  AreaBySide sum;
  sum.fill(Vec3f::Zero());
  const Vec3i centre = s.box.cell(cell), last = s.box.dims - Vec3i::Ones();
  const Vec3i from = (centre.array() - kAround).max(0);
  const Vec3i to = (centre.array() + kAround).min(last.array());
  for (int z = from.z(); z <= to.z(); ++z)
    for (int y = from.y(); y <= to.y(); ++y)
      for (int x = from.x(); x <= to.x(); ++x) {
        const std::int32_t k = find(s, points, gradients, s.box.index({x, y, z}));
        if (k < 0) continue;
        for (std::size_t side = 0; side < sum.size(); ++side)
          sum[side] += sides_[std::size_t(k)][side];
      }
  return sum;
}

}  // namespace resect
