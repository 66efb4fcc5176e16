// Moves tissues through a frame: each by itself, or in common substeps where joints connect them.
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
  TissueStep* step = nullptr;  // overwritten; its memory is reused
};

// duration > 0, s. organs: for the joints, by organ number; may be empty without joints. A frame in
// which a tissue explodes is restored and repeated with substeps of half the length, for all
// tissues joined to it.
void moveTissues(std::span<const MovingTissue> tissues, std::span<const TissueJoint> joints,
                 std::span<const JoinedOrgan> organs, double duration);
void moveTissue(TissueModel& tissue, std::span<const Obstacle> obstacles, double duration,
                TissueStep& step);

}  // namespace resect
