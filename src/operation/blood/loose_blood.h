// Blood that is on no organ, for viewers: puddles on the table and drops in the air.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "blood/bleeding.h"

namespace resect {

struct LooseBlood {
  static constexpr double kDeepest = 5e-3;  // m: the depth that the byte 255 stands for

  // Depth of blood on each patch of the table, 0 to kDeepest, smoothed over neighbouring patches.
  // There are kTableCells x kTableCells patches, x fastest.
  std::vector<std::uint8_t> pool;
  Aabb poolBox;              // round the puddles, world, m
  std::vector<Vec3f> drops;  // positions, world, m
};

// Null if there is no such blood.
std::shared_ptr<const LooseBlood> looseBlood(const Bleeding& blood);

}  // namespace resect
