// Callback through which long work reports its progress and can be cancelled. Long work without
// such a callback can be stopped by a flag (base/stop.h).
#pragma once

#include <functional>

namespace resect {

// The long work calls this function from time to time. share: the share of the work that is done, 0
// to 1; -1: unknown. If the function returns false, the work throws `Cancelled` and leaves no
// partial result. The function may be empty: then nothing is reported.
using Progress = std::function<bool(double share)>;

struct Cancelled {};

inline void report(const Progress& progress, double share) {
  if (progress && !progress(share)) throw Cancelled{};
}

}  // namespace resect
