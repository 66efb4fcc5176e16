#include "sph/node_caps.h"

#include <algorithm>

namespace resect {

double CarvedLine::distance(const Vec3& point) const {
  const Vec3 along = to - from;
  const double square = along.squaredNorm();
  const double share = square > 0 ? std::clamp((point - from).dot(along) / square, 0.0, 1.0) : 0;
  return (from + share * along - point).norm() - radius;
}

Aabb CarvedLine::bounds() const {
  Aabb box;
  box.grow(from), box.grow(to);
  return box.padded(radius);
}

bool NodeCaps::lower(std::int64_t brick, int node, std::uint8_t cap, std::int64_t brickCount) {
  if (cap >= kNone) return false;
  if (recordOf_.empty()) recordOf_.assign(std::size_t(brickCount), -1);
  std::int32_t& record = recordOf_[std::size_t(brick)];
  if (record < 0) {
    record = std::int32_t(bricks_.size());
    bricks_.push_back(std::int32_t(brick));
    caps_.emplace_back().fill(kNone);
  }
  std::uint8_t& now = caps_[std::size_t(record)][std::size_t(node)];
  if (now <= cap) return false;
  now = cap;
  return true;
}

bool NodeCaps::fit(std::int64_t brickCount) {
  recordOf_.clear();
  if (bricks_.size() != caps_.size()) return false;
  if (bricks_.empty()) return true;
  recordOf_.assign(std::size_t(brickCount), -1);
  for (std::size_t i = 0; i < bricks_.size(); ++i) {
    const std::int32_t b = bricks_[i];
    if (b < 0 || b >= brickCount || recordOf_[std::size_t(b)] >= 0) return false;
    if (std::ranges::any_of(caps_[i], [](std::uint8_t cap) { return cap > kNone; })) return false;
    recordOf_[std::size_t(b)] = std::int32_t(i);
  }
  return true;
}

std::size_t NodeCaps::bytes() const {
  return (bricks_.capacity() + recordOf_.capacity()) * 4 + caps_.capacity() * sizeof(Brick);
}

}  // namespace resect
