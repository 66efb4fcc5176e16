// Moves tissues through a frame: each with its own substeps, or all with common ones if there are
// joints.
#pragma once

#include <span>
#include <vector>

#include "tissue/joint.h"
#include "tissue/tissue_model.h"

namespace resect {

// One tissue in a frame, with the obstacles that it can touch.
struct MovingTissue {
  TissueModel* tissue = nullptr;
  std::span<const Obstacle> obstacles;
  TissueStep* step = nullptr;  // receives the result; its memory is reused
};

// Moves tissues through a frame of `duration` > 0, s. organs: by organ number; only joints need
// them. When a tissue explodes, it is restored to the frame's beginning, and the frame is repeated
// with substeps of half the length. If there are joints, this is done with all tissues.
void moveTissues(std::span<const MovingTissue> tissues, std::span<const TissueJoint> joints,
                 std::span<const JoinedOrgan> organs, double duration);
void moveTissue(TissueModel& tissue, std::span<const Obstacle> obstacles, double duration,
                TissueStep& step);

}  // namespace resect
