// Carving: limits of the colour field that an instrument leaves where it takes tissue away.
//
// A cap is the greatest value that the colour field may have at a node. Carving along a line with a
// round instrument gives each node near the line the cap
//
//     50 + 25 (d - radius) / spacing of the nodes, from 0 to 100,
//
// where d is the node's distance from the line, and keeps the lower one of this cap and an earlier
// one. So the surface at the iso level 50 lies on the instrument's path, to about a twentieth of
// the nodes' spacing, whatever the cells are (docs/decisions/0027-fine-bites-by-caps.md). At other
// iso levels it lies up to two nodes beside it. Where the groove meets the skin, the edge is
// rounded off (capped()): a sharp edge is finer than the nodes, and would have teeth.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.h"
#include "geometry/aabb.h"

namespace resect {

// A straight stretch of the path of a round instrument, in rest space, m.
struct CarvedLine {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
  double radius = 0;

  double distance(const Vec3& point) const;  // from the carved surface, m; negative: carved
  Aabb bounds() const;                       // of what is carved
};

// Value and cap that differ by at least this much do not change each other.
inline constexpr float kCapBlend = 25;
// The lower one of a node's value and its cap, and less where they differ by less than kCapBlend: a
// smooth minimum (a polynomial of the second degree, https://iquilezles.org/articles/smin). >= 0.
inline float capped(float value, float cap) {
  const float close = std::max(kCapBlend - std::abs(value - cap), 0.f);
  return std::max(std::min(value, cap) - close * close / (4 * kCapBlend), 0.f);
}

class NodeCaps {
 public:
  static constexpr std::uint8_t kNone = 200;  // no cap; caps are counted in halves of a per cent
  using Brick = std::array<std::uint8_t, 64>;

  bool empty() const { return bricks_.empty(); }
  std::span<const std::int32_t> bricks() const { return bricks_; }  // with caps, in no order
  // The caps of a brick's nodes, x fastest; null: it has none.
  const Brick* of(std::int64_t brick) const {
    if (recordOf_.empty() || recordOf_[std::size_t(brick)] < 0) return nullptr;
    return &caps_[std::size_t(recordOf_[std::size_t(brick)])];
  }
  // Lowers the cap of a node of a brick, if it is not as low already. Returns whether the cap has
  // changed. brickCount: number of bricks of the grid.
  bool lower(std::int64_t brick, int node, std::uint8_t cap, std::int64_t brickCount);

  // Checks loaded caps, and finds recordOf_.
  bool fit(std::int64_t brickCount);
  std::size_t bytes() const;
  template <class Visitor>
  void visit(Visitor& v) {
    v("bricks", bricks_), v("caps", caps_);
  }
  template <class Visitor>
  void visitMade(Visitor& v) {
    v.made(recordOf_);
  }

 private:
  std::vector<std::int32_t> bricks_;    // per record: its brick
  std::vector<Brick> caps_;             // per record
  std::vector<std::int32_t> recordOf_;  // per brick: index of its record or -1; empty: no records
};

}  // namespace resect
