// How do tissues move through a frame? Each by itself, or all together where springs join them:
// then they take the same substeps, and what one pulls with the other feels in the same substep.
#pragma once

#include <span>
#include <vector>

#include "tissue/joint.h"
#include "tissue/tissue_model.h"

namespace resect {

// One tissue in a frame, among the obstacles that it can touch.
struct MovingTissue {
  TissueModel* tissue = nullptr;
  std::span<const Obstacle> obstacles;
  TissueStep* step = nullptr;  // overwritten; its memory is used again
};

// duration > 0, s. organs: for the joints, by organ number; may be empty without joints. Tissue
// that explodes is put back and tried again with substeps of half the length, with all that it is
// joined to.
void moveTissues(std::span<const MovingTissue> tissues, std::span<const TissueJoint> joints,
                 std::span<const JoinedOrgan> organs, double duration);
void moveTissue(TissueModel& tissue, std::span<const Obstacle> obstacles, double duration,
                TissueStep& step);

}  // namespace resect
