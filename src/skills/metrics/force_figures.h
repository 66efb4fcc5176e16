// Figures of the force on an instrument (Horeman et al. 2012, 10.1109/TOH.2011.60).
#pragma once

#include <span>
#include <vector>

#include "skills/metrics/track.h"

namespace resect {

struct ForceFigures {
  double peak = 0;       // N
  double p95 = 0;        // N: 95th percentile of the forces above 0
  double mean = 0;       // N: mean of the forces above 0
  double deviation = 0;  // N: standard deviation of the forces above 0
};
// force: magnitudes of the force, N, at equal intervals. All figures are 0 if no value is above 0.
ForceFigures forceFigures(std::span<const double> force);

// Ranges of successive values that are above `limit`, N. force: as for forceFigures().
std::vector<SampleRange> forceErrors(std::span<const double> force, double limit);

}  // namespace resect
