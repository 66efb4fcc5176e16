#include "operation/smoke/smoke_plume.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace resect;

namespace {

const Vec3 kTip(0.01, 0.05, 0.02);

// The plume after smoke for so many frames, and then none for `clear` frames.
SmokePlume plumeAfter(int frames, int clear = 0, double rate = 2e-5) {
  SmokePlume plume;
  std::vector<Smoke> smoke;
  smoke.push_back({0, 0, kTip, rate});
  for (int i = 1; i <= frames + clear; ++i)
    followSmoke(plume, i <= frames ? std::span<const Smoke>(smoke) : std::span<const Smoke>(),
                i / 60.0, 1 / 60.0);
  return plume;
}

double highest(const std::vector<SmokeBall>& balls) {
  double top = 0;
  for (const SmokeBall& ball : balls) top = std::max(top, double(ball.centre.y()));
  return top;
}

}  // namespace

TEST_CASE("smoke begins at its source, rises, widens and fades") {
  const auto early = smokeBalls(plumeAfter(6), 0.1), later = smokeBalls(plumeAfter(60), 1.0);
  REQUIRE_FALSE(early.empty());
  for (const SmokeBall& ball : early) {
    CHECK((ball.centre.cast<double>() - kTip).norm() < 0.015);
    CHECK(ball.radius < 0.005);
  }
  CHECK(highest(early) < highest(later));
  CHECK(highest(later) > kTip.y() + 0.06);
  // The highest ball is the oldest one: it is wider and thinner than those below it.
  const auto& [old, young] = std::pair(later.front(), later[later.size() - 3]);
  CHECK(old.centre.y() > young.centre.y());
  CHECK(old.radius > 2 * young.radius);
  CHECK(old.density < young.density);
  for (const SmokeBall& ball : later) {
    CHECK(ball.density > 0);
    CHECK(ball.density < 0.5f);
    CHECK(smokeBox(later).padded(1e-6).contains(ball.centre.cast<double>()));
  }
}

TEST_CASE("smoke goes on for three seconds after the burning, then there is none") {
  CHECK(smokeBalls(plumeAfter(0), 0).empty());
  CHECK_FALSE(smokeBalls(plumeAfter(30, 30), 1.0).empty());
  const SmokePlume gone = plumeAfter(30, 180);
  CHECK(gone.puffs.empty());
  CHECK(smokeBalls(gone, 3.5).empty());
}

TEST_CASE("the same steps give the same smoke, and more steam gives denser smoke") {
  const auto once = smokeBalls(plumeAfter(40), 40 / 60.0),
             again = smokeBalls(plumeAfter(40), 40 / 60.0),
             thin = smokeBalls(plumeAfter(40, 0, 2e-6), 40 / 60.0);
  REQUIRE(once.size() == again.size());
  for (std::size_t i = 0; i < once.size(); ++i) {
    CHECK(once[i].centre == again[i].centre);
    CHECK(once[i].density == again[i].density);
  }
  REQUIRE_FALSE(thin.empty());
  CHECK(thin.back().density < 0.6f * once.back().density);
}

TEST_CASE("smoke of another moment is dropped") {
  SmokePlume plume = plumeAfter(60);
  followSmoke(plume, {}, 0.2, 1 / 60.0);
  for (const SmokePuff& puff : plume.puffs) CHECK(puff.began <= 0.2);
}
