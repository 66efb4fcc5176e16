// Callback for the progress of long work, by which it can also be cancelled.
#pragma once

#include <functional>

namespace resect {

// Called from time to time with the share done in [0, 1], or with -1 while it is unknown; returns
// false to cancel, upon which the work throws `Cancelled` and leaves nothing half made. May be an
// empty function.
using Progress = std::function<bool(double share)>;

struct Cancelled {};

inline void report(const Progress& progress, double share) {
  if (progress && !progress(share)) throw Cancelled{};
}

}  // namespace resect
