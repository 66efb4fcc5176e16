// Limits the speed of tools and their jaws to the speed that a hand can give them.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "geometry/pose.h"
#include "geometry/rotation.h"

namespace resect {

constexpr double kSqueezeTime = 0.25;  // s: shortest time from wide open to closed, or back

// Jaws have the squeeze `now` and are to reach the squeeze `wanted`. Returns the squeeze that they
// have after `duration`, s. A squeeze is 0 (wide open) to 1 (closed).
inline double squeezeTowards(double wanted, double now, double duration) {
  const double most = duration / kSqueezeTime;
  return std::clamp(wanted, now - most, now + most);
}

// Jaws may have to close at the place to which their tool moves. Until the tip has arrived there,
// the jaws close at most to this squeeze.
constexpr double kOpenOnTheWay = 0.5;  // squeeze
constexpr double kArrived = 0.004;     // m: a tip has arrived if it is this near to the place

constexpr double kHandTime = 0.04;   // s: time in which a hand covers 63 % of the remaining way
constexpr double kHandTurning = 12;  // rad/s: largest angular speed of a hand
// rad: while a hand still has to turn a tool by more than this, the tool's tip does not move.
constexpr double kTurnsFirst = 0.35;

// How a hand moves a tool to its pose.
struct HandMotion {
  Pose from;             // pose of the tool when it is taken in hand; world
  double fastest = 0.3;  // largest speed, m/s, above 0
};

// A tool has the pose `now` and is to reach the pose `wanted`. Returns the pose that it has after
// `duration`, s. The tool's speed is at most `fastest`, m/s.
inline Pose poseTowards(const Pose& wanted, const Pose& now, double duration, double fastest) {
  constexpr double kNear = 1e-5, kAligned = 1e-3;  // m, rad: within these, the pose is reached
  const double length = (wanted.position - now.position).norm();
  const double angle = angleBetween(now.rotation, wanted.rotation);
  if (length < kNear && angle < kAligned) return wanted;
  const double share = 1 - math::exp(-duration / kHandTime);
  const double moved =
      angle > kTurnsFirst ? 0 : std::min(share, fastest * duration / std::max(length, kNear));
  const double turned = std::min(share, kHandTurning * duration / std::max(angle, kAligned));
  return {now.position + moved * (wanted.position - now.position),
          slerp(now.rotation, wanted.rotation, turned)};
}

}  // namespace resect
