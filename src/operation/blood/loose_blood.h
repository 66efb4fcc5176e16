// Blood that is on no organ, for viewers: puddles on the table and drops in the air.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "blood/bleeding.h"

namespace resect {

struct LooseBlood {
  static constexpr double kDeepest = 5e-3;  // m: what the byte 255 stands for

  // Depth on the table, smoothed over neighbours: kTableCells x kTableCells, x fastest.
  std::vector<std::uint8_t> pool;
  Aabb poolBox;              // round the puddles, world, m
  std::vector<Vec3f> drops;  // world, m
};

// Null if there is none.
std::shared_ptr<const LooseBlood> looseBlood(const Bleeding& blood);

}  // namespace resect
