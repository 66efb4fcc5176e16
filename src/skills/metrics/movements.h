// Movements: ranges of an instrument's track in which the instrument moves. A track holds samples,
// the positions at equal intervals of time (track.h). The rule is that of the training software
// PerkTutor (PythonMetrics): a change between rest and motion is ignored if the new state is too
// short.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "skills/metrics/track.h"

namespace resect {

struct MovementRule {
  double threshold = 0.05;  // m/s, or rad/s for rotations
  double leastTime = 0.2;   // s: a state that lasts no longer is ignored
};
// Threshold for rotations. PerkTutor publishes no threshold of angular speed, so this is a setting
// of ours.
inline constexpr double kRotationThreshold = 0.5;  // rad/s

// The movements, as ranges of samples. speed: one value per sample. The instrument moves while its
// speed is above the threshold, else it rests. A change of state is ignored if the new state lasts
// no longer than leastTime. The state before the first sample is rest. interval: s between samples.
std::vector<SampleRange> movements(std::span<const double> speed, double interval,
                                   const MovementRule& rule = {});

// Sums over several movements, m. length: sum of their path lengths. distance: sum of the distances
// between their start and end positions.
struct Ways {
  double length = 0, distance = 0;
};
void addWays(Ways& ways, const Track& track, std::span<const SampleRange> movements);
// 100 (length / distance - 1), %; nothing if the distance is 0.
std::optional<double> pathInefficiency(const Ways& ways);

}  // namespace resect
