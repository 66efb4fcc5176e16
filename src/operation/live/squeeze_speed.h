// Limits the opening and closing of jaws to the speed of a hand.
#pragma once

#include <algorithm>

namespace resect {

constexpr double kSqueezeTime = 0.25;  // s: least time from wide open to closed, or back

// The squeeze that jaws reach after `duration`, s, if they have the squeeze `now` and are to reach
// `wanted`. A squeeze is 0 (wide open) to 1 (closed).
inline double squeezeTowards(double wanted, double now, double duration) {
  const double most = duration / kSqueezeTime;
  return std::clamp(wanted, now - most, now + most);
}

}  // namespace resect
