// Callback that reports the progress of long work and can cancel it.
#pragma once

#include <functional>

namespace resect {

// Called from time to time with the share of the work that is done, 0 to 1, or -1 while it is
// unknown. If it returns false, the work throws `Cancelled` and leaves nothing half made. It may be
// an empty function.
using Progress = std::function<bool(double share)>;

struct Cancelled {};

inline void report(const Progress& progress, double share) {
  if (progress && !progress(share)) throw Cancelled{};
}

}  // namespace resect
