// Measures the noise of the force on a hand that holds an instrument still and presses it on
// tissue.
#pragma once

#include <span>

#include "haptics/loop/haptic_loop.h"

namespace resect {

// The haptic loop computes a force every millisecond; each result is a sample. Noise is measured in
// windows of 200 consecutive samples (0.2 s). A window is used only if in all its samples the force
// is at least 0.05 N and the hand is meant to hold the instrument still (HapticSample::still). In
// each window a polynomial of degree 4 in time is fitted to every component of the force. The
// polynomial follows changes up to about 8 Hz, such as relaxation and the swinging of an organ. The
// noise of a window is the rms of the difference between force and polynomial, divided by the mean
// magnitude of the force in the window.
struct ForceNoise {
  std::int64_t windows = 0;  // number of windows
  double typical = 0;        // rms of the noise over all windows, as a fraction of the force
  double worst = 0;          // largest noise of a window, as a fraction of the force
};
// samples: the samples of one hand, in the order of time.
ForceNoise forceNoise(std::span<const HapticSample> samples);

}  // namespace resect
