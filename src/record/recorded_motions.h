// The motions of the instruments in a recorded operation, as keys of a scenario. So an attempt that
// somebody has made becomes the reference run of an exercise: it can be played, and shown as
// ghosts.
#pragma once

#include <vector>

#include "operation/scenario.h"
#include "record/file/recording_file.h"

namespace resect {

// How far the motion of the keys may be from the recorded one.
struct MotionTolerance {
  double distance = 3e-4;  // m, of the tip
  double angle = 0.01;     // rad
  double share = 0.02;     // of squeeze and pedal
};

// Keys per tool of RecordingFile::setup().scenario, along the course that leads to the moment
// (courseTo()). Keys begin where the tool is in hand for the first time and end where it is for the
// last time; none if it never is. While it was put back in between, it lies where it was put.
// Throws Error if the recording is damaged.
std::vector<std::vector<ToolKey>> recordedMotions(RecordingFile& file, const Moment& moment,
                                                  const MotionTolerance& tolerance = {});

// The fewest keys that stay within the tolerance of all of these, found by halving (Douglas and
// Peucker 1973); the first and the last are kept. keys: in ascending order of time.
std::vector<ToolKey> thinned(const std::vector<ToolKey>& keys, const MotionTolerance& tolerance);

}  // namespace resect
