// Measures of an instrument's path, which is given by samples: positions at equal intervals of time
// (track.h). Definitions and sources: docs/methods/skills.md.
#pragma once

#include <span>

#include "skills/metrics/track.h"

namespace resect {

inline constexpr double kIdleSpeed = 0.005;  // m/s: a slower tip counts as idle; a setting of ours

// Sum of the distances between successive samples, m.
double pathLength(std::span<const Vec3> tip);
// Distance that the tip moves along the instrument's axis, m. Motion in either direction counts as
// positive; the distances from sample to sample are added. Needs Track::turn.
double depthMovement(const Track& track);
// Sum of the angles by which the instrument turned from sample to sample, rad. Needs Track::turn.
double totalRotation(const Track& track);
// Speed at each sample, m/s, by central differences, and by one-sided differences at both ends. If
// there is only one sample, its speed is 0.
std::vector<double> speeds(const Track& track);
// Angular speed at each sample, rad/s, computed as speeds() computes the speed. Needs Track::turn.
std::vector<double> angularSpeeds(const Track& track);
// Total time, s, during which the speed was below `slow`, m/s.
double idleTime(const Track& track, double slow = kIdleSpeed);

}  // namespace resect
