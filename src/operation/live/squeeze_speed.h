// Limits the closing of jaws to the speed of a hand.
#pragma once

#include <algorithm>

namespace resect {

constexpr double kSqueezeTime = 0.25;  // s, from wide open to closed

// The squeeze, 0 wide open to 1 closed, that jaws reach after `duration`, s, on the way from `now`
// to `wanted`.
inline double squeezeTowards(double wanted, double now, double duration) {
  const double most = duration / kSqueezeTime;
  return std::clamp(wanted, now - most, now + most);
}

}  // namespace resect
