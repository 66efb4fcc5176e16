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
  double rate = 0;                 // moments per second of the operation; 0: every frame
};

// Plays the part. Calls visit() for its first state and after its last frame. In between it calls
// visit() for each whole number k, after the first frame that ends at the time k / rate or later;
// once if this is the same frame for several k. If withLook is set, it first calls
// Simulation::keepLook(). each(), if given, is called for every frame, before visit().
void playMoments(Replay& replay, const ExportedPart& part, bool withLook,
                 const std::function<void(const Simulation&)>& visit, const Progress& progress,
                 const std::function<void(const StepReport&)>& each = {});

// Whether playMoments() calls visit() at the end of that frame.
bool isDue(std::int64_t frame, double frameRate, const ExportedPart& part);

}  // namespace resect
