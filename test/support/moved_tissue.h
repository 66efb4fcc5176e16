// A frame of tissue among obstacles, with what tears and slips done at once, as a simulation does
// it.
#pragma once

#include "tissue/move_tissues.h"

namespace resect::test {

inline Obstacle instrument(std::int32_t tool, const SignedDistance* shape, const Pose& from,
                           const Pose& to, double friction, double slipForce) {
  return {tool, shape, false, from, to, false, friction, slipForce};
}

inline void moveAndTear(TissueModel& tissue, double duration, std::span<const Obstacle> obstacles,
                        TissueStep& step) {
  moveTissue(tissue, obstacles, duration, step);
  for (const std::int32_t tool : step.letGo) tissue.release(tool);
  for (const TissueBond& bond : step.torn) tissue.sever(bond.cell, bond.direction);
  tissue.settle();
}

}  // namespace resect::test
