// Blood that is not on an organ, for viewers: puddles on the table and drops in the air.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "blood/bleeding.h"

namespace resect {

struct LooseBlood {
  static constexpr double kDeepest = 5e-3;  // m: greatest depth that `pool` can show

  // Depth of blood on each square of the table, smoothed over neighbouring squares. The bytes 0 to
  // 255 stand for depths of 0 to kDeepest. There are kTableCells x kTableCells squares, x fastest.
  std::vector<std::uint8_t> pool;
  Aabb poolBox;  // box that encloses the puddles, world, m
  // Positions, world, m. A drop is seen as a streak, as a camera sees it: points close together
  // along the way that the drop has gone in the last 1/60 s.
  std::vector<Vec3f> drops;
};

// Null if there is no such blood.
std::shared_ptr<const LooseBlood> looseBlood(const Bleeding& blood);

}  // namespace resect
