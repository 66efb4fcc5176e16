// Where does a column enter and leave a body, counted in the points of a line along it? For
// collision/inside_samples_plainly.cpp and the path by spans beside it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "collision/inside_samples.h"

namespace resect {

// A crossing by the first point beyond it; of two at the same one entering comes first, so that
// shells that touch give one stretch.
using Step = std::uint32_t;
inline Step step(std::int32_t point, std::int32_t sign) {
  return Step(point) << 1 | Step(sign < 0);
}

// Points that an estimate of the first one beyond a depth may be wrong by, if it is worked out in
// double precision.
inline double slackOf(const SampleLine& line) {
  return 1e-12 * (line.count + std::abs(line.first) / line.pitch);
}

// Writes the stretches of a column whose steps are sorted, in numbers of any width; returns behind
// the last.
template <typename AnyStep>
InsideStretch* writeStretches(std::span<const AnyStep> sorted, InsideStretch* to) {
  int winding = 0;
  AnyStep entered = 0;
  for (const AnyStep s : sorted) {
    const int before = winding;
    winding += s & 1 ? -1 : 1;
    if (before <= 0 && winding > 0) entered = s;
    if (before > 0 && winding <= 0 && entered >> 1 < s >> 1)
      *to++ = {std::int32_t(entered >> 1), std::int32_t(s >> 1)};
  }
  return to;
}

}  // namespace resect
