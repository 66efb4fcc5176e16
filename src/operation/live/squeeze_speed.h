// How far do jaws close within a frame, as fast as a hand can squeeze them?
#pragma once

#include <algorithm>

namespace resect {

constexpr double kSqueezeTime = 0.25;  // s, from wide open to closed

// What they reach of `wanted` (0 wide open to 1 closed) within `duration`, s, from where they are.
inline double squeezeTowards(double wanted, double now, double duration) {
  const double most = duration / kSqueezeTime;
  return std::clamp(wanted, now - most, now + most);
}

}  // namespace resect
