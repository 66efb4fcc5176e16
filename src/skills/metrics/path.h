// Measures of an instrument's path. Definitions and sources: docs/methods/skills.md.
#pragma once

#include <span>

#include "skills/metrics/track.h"

namespace resect {

inline constexpr double kIdleSpeed = 0.005;  // m/s: a slower tip counts as idle; a setting of ours

// Sum of the distances between successive samples, m.
double pathLength(std::span<const Vec3> tip);
// Sum of the distances that the tip moves along the instrument's axis, in either direction, from
// sample to sample, m. Needs Track::turn.
double depthMovement(const Track& track);
// Sum of the angles by which the instrument turned from sample to sample, rad. Needs Track::turn.
double totalRotation(const Track& track);
// Speed at each sample by central differences, one-sided at the ends, m/s. All zero for a single
// sample.
std::vector<double> speeds(const Track& track);
// The same for the angular speed, rad/s. Needs Track::turn.
std::vector<double> angularSpeeds(const Track& track);
// Total time, s, during which the speed was below `slow`, m/s.
double idleTime(const Track& track, double slow = kIdleSpeed);

}  // namespace resect
