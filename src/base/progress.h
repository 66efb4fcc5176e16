// How does long work show how far it is, and how is it cancelled?
#pragma once

#include <functional>

namespace resect {

// Called now and then with the share done in [0, 1], or with -1 while nobody knows it; returns
// false to cancel, upon which the work throws `Cancelled` and leaves nothing half made. An empty
// function is allowed: nobody watches.
using Progress = std::function<bool(double share)>;

struct Cancelled {};

inline void report(const Progress& progress, double share) {
  if (progress && !progress(share)) throw Cancelled{};
}

}  // namespace resect
