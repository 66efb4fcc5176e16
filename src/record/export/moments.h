// The moments of a recorded operation that an export shows.
#pragma once

#include <functional>
#include <span>

#include "base/progress.h"
#include "record/course.h"
#include "record/replay.h"

namespace resect {

// Which part of a recording, and how densely.
struct ExportedPart {
  std::vector<CourseSpan> course;  // from partOf(), not empty
  double rate = 0;                 // moments per second of the operation; 0: every frame
};

// Plays the part and calls visit() for its first state, then for the first frame that ends at
// k / rate or later, for each k, and for the last frame. Before the first call of visit(),
// Simulation::keepLook() is called if withLook is set. each(), if given, is called for every frame,
// before visit().
void playMoments(Replay& replay, const ExportedPart& part, bool withLook,
                 const std::function<void(const Simulation&)>& visit, const Progress& progress,
                 const std::function<void(const StepReport&)>& each = {});

// Whether a moment is due at the end of that frame.
bool isDue(std::int64_t frame, double frameRate, const ExportedPart& part);

}  // namespace resect
