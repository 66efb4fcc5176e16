// Rounds times that are printed in tables and JSON.
#pragma once

#include <cmath>

namespace resect {

// Rounds a time in s to nanoseconds, so that a sum of the durations of frames, such as
// 9.200000000000037 s, is printed as 9.2.
inline double printedTime(double seconds) { return std::round(seconds * 1e9) / 1e9; }

}  // namespace resect
