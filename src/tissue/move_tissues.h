// Moves tissues through a frame. Joints are springs between two organs. Without joints each tissue
// has its own number of substeps; with joints all tissues have the same number.
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

// Moves tissues through a frame of `duration` s, > 0. organs: entry i is the organ with number i;
// needed only if there are joints. A tissue explodes if its time integration becomes unstable. It
// is then restored to the frame's beginning, and the frame is repeated with substeps of half the
// length. If there are joints, all tissues are restored and repeat the frame. Before each substep,
// throws Cancelled if a stop was requested (base/stop.h).
void moveTissues(std::span<const MovingTissue> tissues, std::span<const TissueJoint> joints,
                 std::span<const JoinedOrgan> organs, double duration);
// As moveTissues(), for one tissue without joints.
void moveTissue(TissueModel& tissue, std::span<const Obstacle> obstacles, double duration,
                TissueStep& step);

}  // namespace resect
