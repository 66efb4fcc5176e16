// Measures the noise of the force while a hand holds an instrument still in contact with tissue.
#pragma once

#include <span>

#include "haptics/loop/haptic_loop.h"

namespace resect {

// Noise is measured in windows of 200 consecutive samples (0.2 s). A window contains only samples
// in which the force is at least 0.05 N and the hand is to hold the instrument still
// (HapticSample::still). In each window a polynomial of degree 4 in time is fitted to every
// component of the force. The polynomial follows changes up to about 8 Hz, such as relaxation and
// the swinging of an organ. The noise of a window is the rms of the difference between force and
// polynomial, divided by the mean magnitude of the force.
struct ForceNoise {
  std::int64_t windows = 0;  // number of windows
  double typical = 0;        // rms of the noise over all windows, as a fraction of the force
  double worst = 0;          // largest noise of a window, as a fraction of the force
};
// samples: the samples of one hand, in the order of time.
ForceNoise forceNoise(std::span<const HapticSample> samples);

}  // namespace resect
