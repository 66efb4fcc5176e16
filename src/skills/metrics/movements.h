// Movements: ranges of a track in which the instrument moves. By PerkTutor's rule (its
// PythonMetrics), a change between rest and motion counts only if it lasts.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "skills/metrics/track.h"

namespace resect {

struct MovementRule {
  double threshold = 0.05;  // m/s, or rad/s for rotations
  double leastTime = 0.2;   // s: a shorter change of state is ignored
};
// For rotations. PerkTutor publishes no threshold of angular speed, so this is a setting of ours.
inline constexpr double kRotationThreshold = 0.5;  // rad/s

// Ranges of samples in which the speed was above the threshold, after changes of state that lasted
// no longer than leastTime were ignored. The state before the first sample is rest.
std::vector<SampleRange> movements(std::span<const double> speed, double interval,
                                   const MovementRule& rule = {});

// Sums over movements, m: of the path length, and of the distance between start and end.
struct Ways {
  double length = 0, distance = 0;
};
void addWays(Ways& ways, const Track& track, std::span<const SampleRange> movements);
// 100 (length / distance - 1), %; nothing if the distance is 0.
std::optional<double> pathInefficiency(const Ways& ways);

}  // namespace resect
