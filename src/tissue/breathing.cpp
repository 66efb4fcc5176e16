#include "tissue/breathing.h"

#include <cmath>
#include <numbers>

#include "base/elementary.h"

namespace resect {

double breathWave(double phase) {
  const double sine = math::sin(std::numbers::pi * (phase - std::floor(phase)));
  return sine * sine * sine * sine;
}

Vec3 BreathMotion::displacement(double share) const {
  return {0, 0, depth * breathWave(from + share * (to - from))};
}

Vec3 BreathMotion::velocity(double share) const {
  if (!(duration > 0)) return Vec3::Zero();
  const double phase = from + share * (to - from);
  const double angle = std::numbers::pi * (phase - std::floor(phase)), sine = math::sin(angle);
  const double slope = 4 * std::numbers::pi * sine * sine * sine * math::cos(angle);
  return {0, 0, depth * slope * (to - from) / duration};
}

BreathMotion breathe(const Breathing& breathing, Breath& breath, double duration) {
  BreathMotion motion{breathing.depth, breath.phase, breath.phase, duration};
  if (!breath.on && breath.phase == 0) return motion;  // held between two breaths
  motion.to += duration * breathing.perMinute / 60;
  if (motion.to >= 1 && !breath.on) {  // this was the last breath
    motion.to = 1;
    breath.phase = 0;
  } else {
    breath.phase = motion.to - std::floor(motion.to);
  }
  return motion;
}

}  // namespace resect
