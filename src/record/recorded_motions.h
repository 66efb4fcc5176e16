// Converts the motions of the instruments in a recorded operation to keys of a scenario, which are
// poses at given times. So a recorded attempt can become the reference run of an exercise. The
// reference run can be played, or shown by transparent instruments (ghosts).
#pragma once

#include <vector>

#include "operation/scenario.h"
#include "record/file/recording_file.h"

namespace resect {

// The keys give a motion that may deviate from the recorded motion by at most these amounts.
struct MotionTolerance {
  double distance = 3e-4;  // m, of Pose::position
  double angle = 0.01;     // rad
  double share = 0.02;     // of squeeze and pedal, which are 0 to 1
};

// Returns a list of keys for each tool of RecordingFile::setup().scenario. The keys give the tool's
// motion in the frames that lead from the start of the operation to `moment` (see courseTo()). The
// first key is at the beginning of the first period in which the tool is in hand, the last key at
// the end of the last such period. If the tool is out of hand in between, the keys follow its
// recorded pose. A tool that is never in hand has no keys. Throws Error if the recording is
// damaged.
std::vector<std::vector<ToolKey>> recordedMotions(RecordingFile& file, const Moment& moment,
                                                  const MotionTolerance& tolerance = {});

// Leaves out keys by the algorithm of Douglas and Peucker (1973). The motion interpolated between
// the remaining keys deviates from each of the given keys by at most the tolerance. The first and
// the last key remain. keys: in ascending order of time.
std::vector<ToolKey> thinned(const std::vector<ToolKey>& keys, const MotionTolerance& tolerance);

}  // namespace resect
