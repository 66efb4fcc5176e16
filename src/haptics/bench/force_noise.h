// How noisy a force is while a hand holds an instrument still in contact.
#pragma once

#include <span>

#include "haptics/loop/haptic_loop.h"

namespace resect {

// Windows of 0.2 s are taken from the times in which the hand has wanted to hold still for 0.1 s
// already and the force is above 0.05 N throughout. In each window every component of the force is
// fitted by a polynomial of degree 4 in time, which follows changes up to about 8 Hz, such as
// relaxation and the swinging of an organ. The noise is the rms of what is left, divided by the
// mean magnitude of the force.
struct ForceNoise {
  std::int64_t windows = 0;
  double typical = 0;  // rms over all windows, a share of the force
  double worst = 0;    // in one window
};
ForceNoise forceNoise(std::span<const HapticSample> samples);

}  // namespace resect
