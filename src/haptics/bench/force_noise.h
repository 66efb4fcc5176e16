// How noisy a force is while a hand holds an instrument still in contact.
#pragma once

#include <span>

#include "haptics/loop/haptic_loop.h"

namespace resect {

// Noise is measured in windows of 0.2 s. In every sample of a window the force is at least 0.05 N,
// and the hand's wanted pose is what it was 0.1 s before. In each window every component of the
// force is fitted by a polynomial of degree 4 in time, which follows changes up to about 8 Hz, such
// as relaxation and the swinging of an organ. The noise is the rms of what is left, divided by the
// mean magnitude of the force.
struct ForceNoise {
  std::int64_t windows = 0;
  double typical = 0;  // rms over all windows, a share of the force
  double worst = 0;    // in one window
};
ForceNoise forceNoise(std::span<const HapticSample> samples);

}  // namespace resect
