#include "operation/smoke/smoke_plume.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"

namespace resect {
namespace {

constexpr double kPerSecond = 30;     // puffs of one source
constexpr double kLife = 2.8;         // s
constexpr double kDense = 1.5e-5;     // kg/s of steam that make the smoke as dense as it becomes
constexpr std::size_t kMost = 120;    // puffs
constexpr double kDensest = 0.60;     // of a puff
constexpr double kLeastSeen = 0.004;  // a ball of a lower density is not drawn

// Where a puff of this age, s, is. Puffs that began one after the other stay near each other, so
// that the plume is a wisp which sways and curls the more, the higher it has risen.
Vec3 placeOf(const SmokePuff& puff, double age) {
  const double up = 0.085 * age - 0.010 * age * age;  // the air slows it down
  const double drift = 0.012 * age * age, curl = 0.0045 * age + 0.0055 * age * age;
  const double phase = 5.3 * puff.began + 40 * puff.from.x() - 1.9 * age;
  return puff.from + Vec3(drift + curl * math::sin(phase), up,
                          -0.6 * drift + curl * math::cos(0.83 * phase + 1.1));
}

}  // namespace

void followSmoke(SmokePlume& plume, std::span<const Smoke> smoke, double time, double duration) {
  std::erase_if(plume.puffs, [&](const SmokePuff& puff) {
    return time - puff.began > kLife || time < puff.began;
  });
  // A source gives a puff whenever simulated time passes a multiple of 1 / kPerSecond.
  if (std::floor(time * kPerSecond + 1e-6) <= std::floor((time - duration) * kPerSecond + 1e-6))
    return;
  for (const Smoke& source : smoke) {
    const double strength = std::min(1.0, std::sqrt(source.rate / kDense));
    if (strength > 0.02 && plume.puffs.size() < kMost)
      plume.puffs.push_back({source.place, time, strength});
  }
}

std::vector<SmokeBall> smokeBalls(const SmokePlume& plume, double time) {
  std::vector<SmokeBall> balls;
  for (const SmokePuff& puff : plume.puffs) {
    const double age = time - puff.began;
    if (age < 0 || age > kLife) continue;
    const double left = 1 - age / kLife, radius = 0.0022 + 0.0120 * age;
    // It thins out as it widens.
    const double density = kDensest * puff.strength * std::min(1.0, 0.35 + 8 * age) * left *
                           std::sqrt(left) / (1 + 1.4 * age);
    if (density < kLeastSeen) continue;
    balls.push_back({placeOf(puff, age).cast<float>(), float(radius), float(density)});
  }
  return balls;
}

Aabb smokeBox(std::span<const SmokeBall> balls) {
  Aabb box;
  for (const SmokeBall& ball : balls) {
    const Vec3 middle = ball.centre.cast<double>();
    box.grow(middle - Vec3::Constant(double(ball.radius)));
    box.grow(middle + Vec3::Constant(double(ball.radius)));
  }
  return box;
}

}  // namespace resect
