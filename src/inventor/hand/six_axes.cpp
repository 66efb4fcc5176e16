#include "inventor/hand/six_axes.h"

#include <algorithm>
#include <cmath>

namespace resect {
namespace {

constexpr double kAtRest = 12;         // counts: dead zone for a hand that rests on the cap
constexpr double kMetresEach = 4e-4;   // m/s per count: 14 cm/s at full deflection
constexpr double kRadiansEach = 4e-3;  // rad/s per count
constexpr double kLongest =
    0.1;  // s: longest interval counted, so that nothing jumps after a pause in the reports

Vec3 beyondRest(const Vec3& counts) {
  return counts.unaryExpr(
      [](double c) { return std::abs(c) <= kAtRest ? 0.0 : c - std::copysign(kAtRest, c); });
}

}  // namespace

ViewMotion motionOf(const SixAxes& axes, double seconds) {
  const double time = std::clamp(seconds, 0.0, kLongest);
  return {beyondRest(axes.push) * (kMetresEach * time),
          beyondRest(axes.turn) * (kRadiansEach * time)};
}

}  // namespace resect
