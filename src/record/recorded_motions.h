// Converts the motions of the instruments in a recorded operation to keys of a scenario. So a
// recorded attempt can become the reference run of an exercise, which can be played and shown as
// ghosts.
#pragma once

#include <vector>

#include "operation/scenario.h"
#include "record/file/recording_file.h"

namespace resect {

// Greatest allowed deviation of the motion that the keys give from the recorded motion.
struct MotionTolerance {
  double distance = 3e-4;  // m, of Pose::position
  double angle = 0.01;     // rad
  double share = 0.02;     // of squeeze and pedal, which are 0 to 1
};

// For each tool of RecordingFile::setup().scenario, its keys along the course that leads to the
// moment (courseTo()). The keys begin when the tool is in hand for the first time and end when it
// is in hand for the last time; a tool that is never in hand has no keys. For periods in between in
// which the tool is not in hand, the keys follow its recorded pose. Throws Error if the recording
// is damaged.
std::vector<std::vector<ToolKey>> recordedMotions(RecordingFile& file, const Moment& moment,
                                                  const MotionTolerance& tolerance = {});

// A subset of the keys whose interpolated motion deviates from all keys by at most the tolerance
// (the algorithm of Douglas and Peucker 1973). It includes the first and the last key. keys: in
// ascending order of time.
std::vector<ToolKey> thinned(const std::vector<ToolKey>& keys, const MotionTolerance& tolerance);

}  // namespace resect
