// The moments of a recorded operation that an export shows.
#pragma once

#include <functional>
#include <span>

#include "base/progress.h"
#include "record/course.h"
#include "record/replay.h"

namespace resect {

// Which part of a recording is exported, and how many moments of it.
struct ExportedPart {
  std::vector<CourseSpan> course;  // from partOf(), not empty
  double rate = 0;                 // moments per simulated second; 0: one at every frame
};

// Plays the part. Calls visit() for the first state of the part, after its last frame, and after
// chosen frames in between. If the rate is 0, every frame is chosen. If the rate is above 0, a
// frame is chosen if it is the first to end at or after one of the simulated times 1 / rate, 2 /
// rate, and so on, s. If withLook is set, Simulation::keepLook() is called before the part is
// played. each(), if given, is called for every frame, before visit().
void playMoments(Replay& replay, const ExportedPart& part, bool withLook,
                 const std::function<void(const Simulation&)>& visit, const Progress& progress,
                 const std::function<void(const StepReport&)>& each = {});

// Whether playMoments() calls visit() at the end of `frame`. frameRate: frames per simulated
// second.
bool isDue(std::int64_t frame, double frameRate, const ExportedPart& part);

}  // namespace resect
