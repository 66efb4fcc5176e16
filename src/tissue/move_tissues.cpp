#include "tissue/move_tissues.h"

#include <algorithm>

#include "base/error.h"
#include "base/stop.h"

namespace resect {
namespace {

// One attempt at the frame; returns the tissue that exploded, or null.
TissueModel* tryFrame(std::span<const MovingTissue> tissues, std::span<const TissueJoint> joints,
                      std::span<const JoinedOrgan> organs) {
  int count = 0;
  for (const MovingTissue& t : tissues) count = std::max(count, t.tissue->substepsWanted());
  for (int number = 1; number <= count; ++number) {
    checkStop();
    pullJoints(joints, organs);
    for (const MovingTissue& t : tissues)
      if (!t.tissue->substep(number, count)) return t.tissue;
  }
  return nullptr;
}

void moveTogether(std::span<const MovingTissue> tissues, std::span<const TissueJoint> joints,
                  std::span<const JoinedOrgan> organs, double duration) {
  for (const MovingTissue& t : tissues) t.tissue->beginFrame(duration, t.obstacles);
  while (const TissueModel* exploded = tryFrame(tissues, joints, organs)) {
    bool goOn = true;
    for (const MovingTissue& t : tissues) goOn = t.tissue->startAgain(t.tissue == exploded) && goOn;
    // No shorter substep: the tissues joined to it stay where they are for this frame.
    if (!goOn) break;
  }
  for (const MovingTissue& t : tissues) t.tissue->endFrame(*t.step);
}

}  // namespace

void moveTissues(std::span<const MovingTissue> tissues, std::span<const TissueJoint> joints,
                 std::span<const JoinedOrgan> organs, double duration) {
  require(duration > 0, "the frame lasts {} s; give a time above 0", duration);
  if (!joints.empty()) return moveTogether(tissues, joints, organs, duration);
  for (const MovingTissue& t : tissues) moveTogether({&t, 1}, {}, {}, duration);
}

void moveTissue(TissueModel& tissue, std::span<const Obstacle> obstacles, double duration,
                TissueStep& step) {
  require(duration > 0, "the frame lasts {} s; give a time above 0", duration);
  const MovingTissue one{&tissue, obstacles, &step};
  moveTogether({&one, 1}, {}, {}, duration);
}

}  // namespace resect
