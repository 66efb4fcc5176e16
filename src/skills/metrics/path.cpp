#include "skills/metrics/path.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "geometry/rotation.h"

namespace resect {
namespace {

void requireTurns(const Track& track) {
  require(track.turn.size() == track.tip.size(),
          "the track has {} rotations for {} places; give one for each", track.turn.size(),
          track.tip.size());
}

// Central differences of a quantity of which `between(a, b)` is the amount from sample a to b.
template <typename Between>
std::vector<double> rates(std::size_t count, double interval, Between between) {
  require(interval > 0, "the track's interval is {} s; give more than 0", interval);
  std::vector<double> rate(count, 0.0);
  for (std::size_t i = 0; i < count && count > 1; ++i) {
    const std::size_t a = i > 0 ? i - 1 : 0, b = std::min(i + 1, count - 1);
    rate[i] = between(a, b) / (interval * double(b - a));
  }
  return rate;
}

}  // namespace

double pathLength(std::span<const Vec3> tip) {
  double length = 0;
  for (std::size_t i = 1; i < tip.size(); ++i) length += (tip[i] - tip[i - 1]).norm();
  return length;
}

double depthMovement(const Track& track) {
  requireTurns(track);
  double length = 0;
  for (std::size_t i = 1; i < track.tip.size(); ++i)
    length += std::abs((track.tip[i] - track.tip[i - 1]).dot(track.turn[i] * track.axis));
  return length;
}

double totalRotation(const Track& track) {
  requireTurns(track);
  double angle = 0;
  for (std::size_t i = 1; i < track.turn.size(); ++i)
    angle += angleBetween(track.turn[i - 1], track.turn[i]);
  return angle;
}

std::vector<double> speeds(const Track& track) {
  return rates(track.tip.size(), track.interval,
               [&](std::size_t a, std::size_t b) { return (track.tip[b] - track.tip[a]).norm(); });
}

std::vector<double> angularSpeeds(const Track& track) {
  requireTurns(track);
  return rates(track.turn.size(), track.interval, [&](std::size_t a, std::size_t b) {
    return angleBetween(track.turn[a], track.turn[b]);
  });
}

double idleTime(const Track& track, double slow) {
  double time = 0;
  for (std::size_t i = 1; i < track.tip.size(); ++i)
    if ((track.tip[i] - track.tip[i - 1]).norm() < slow * track.interval) time += track.interval;
  return time;
}

}  // namespace resect
