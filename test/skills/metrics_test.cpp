// The measures of paths, forces and learning curves, on paths and lists whose values are known.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "base/error.h"
#include "geometry/rotation.h"
#include "skills/metrics/force_figures.h"
#include "skills/metrics/learning_curve.h"
#include "skills/metrics/movements.h"
#include "skills/metrics/path.h"
#include "skills/metrics/smoothness.h"
#include "skills/metrics/spectrum.h"
#include "skills/metrics/two_hands.h"

using namespace resect;

namespace {

// A bell of speed: v = exp(-5 t^2), t in [-1, 1).
std::vector<double> bell(double step = 0.01) {
  std::vector<double> v;
  for (int i = 0; i < int(std::lround(2 / step)); ++i) {
    const double t = -1 + i * step;
    v.push_back(std::exp(-5 * t * t));
  }
  return v;
}

Track straight(double speed, double seconds, double interval = 1.0 / 60) {
  Track track{interval, {}, {}, Vec3::UnitZ()};
  for (int i = 0; i <= int(std::lround(seconds / interval)); ++i) {
    track.tip.push_back(Vec3(0.1, 0.2, 0.3) + i * interval * speed * Vec3(0, 0.6, 0.8));
    track.turn.push_back(rotationAbout(Vec3::UnitX(), 0.1 * i * interval));
  }
  return track;
}

}  // namespace

TEST_CASE("smoothness of a bell of speed is what the reference implementation gives") {
  CHECK(*spectralArcLength(bell(), 0.01) == doctest::Approx(-1.41403).epsilon(1e-5));
  CHECK(*logDimensionlessJerk(bell(), 0.01) == doctest::Approx(-5.81636).epsilon(1e-5));
}

TEST_CASE("smoothness does not depend on the size of the speed, and sinks with a tremor") {
  std::vector<double> large = bell(), shaken = bell();
  for (double& v : large) v *= 7;
  for (std::size_t i = 0; i < shaken.size(); ++i)
    shaken[i] += 0.1 * std::sin(2 * std::numbers::pi * 8 * 0.01 * double(i));
  CHECK(*spectralArcLength(large, 0.01) == doctest::Approx(*spectralArcLength(bell(), 0.01)));
  CHECK(*logDimensionlessJerk(large, 0.01) == doctest::Approx(*logDimensionlessJerk(bell(), 0.01)));
  CHECK(*spectralArcLength(shaken, 0.01) < *spectralArcLength(bell(), 0.01) - 0.1);
  CHECK(*logDimensionlessJerk(shaken, 0.01) < *logDimensionlessJerk(bell(), 0.01) - 1);
}

TEST_CASE("what does not move has no smoothness") {
  const std::vector<double> still(50, 0.0);
  CHECK(!spectralArcLength(still, 0.01));
  CHECK(!logDimensionlessJerk(still, 0.01));
  CHECK(!frequency95(std::vector<double>(50, 0.3), 0.01));
  CHECK(!spectralArcLength(std::vector<double>{1.0}, 0.01));
}

TEST_CASE("the 95 % frequency is that of a sine") {
  std::vector<double> wave;
  for (int i = 0; i < 512; ++i)
    wave.push_back(1 + std::sin(2 * std::numbers::pi * 6.25 * i / 100));  // 32 periods
  CHECK(*frequency95(wave, 0.01) == doctest::Approx(6.25));
}

TEST_CASE("length, depth, rotation and idle time of a straight way") {
  const Track track = straight(0.05, 2);
  CHECK(pathLength(track.tip) == doctest::Approx(0.1));
  CHECK(totalRotation(track) == doctest::Approx(0.2).epsilon(1e-6));
  CHECK(idleTime(track) == 0);
  CHECK(idleTime(straight(0.004, 2)) == doctest::Approx(2));
  Track along = track;
  for (auto& turn : along.turn) turn.setIdentity();  // the axis is z, the way has 0.8 of it
  CHECK(depthMovement(along) == doctest::Approx(0.08));
  for (const double v : speeds(track)) CHECK(v == doctest::Approx(0.05));
  for (const double w : angularSpeeds(track)) CHECK(w == doctest::Approx(0.1).epsilon(1e-6));
}

TEST_CASE("a quarter of a circle is longer than the distance of its ends by pi / 4 sqrt(2)") {
  Track track{0.01, {}, {}, Vec3::UnitZ()};
  for (int i = 0; i <= 1000; ++i) {
    const double a = 0.5 * std::numbers::pi * i / 1000;
    track.tip.push_back({0.1 * std::cos(a), 0, 0.1 * std::sin(a)});
  }
  const std::vector<SampleRange> all{{0, 1000}};
  const double ratio = 0.5 * std::numbers::pi / std::sqrt(2.0);
  const auto inefficiency = [&](std::span<const SampleRange> movements) {
    Ways ways;
    addWays(ways, track, movements);
    return pathInefficiency(ways);
  };
  CHECK(*inefficiency(all) == doctest::Approx(100 * (ratio - 1)).epsilon(1e-4));
  track.tip.push_back(track.tip.front());  // back to the start: undefined
  const std::vector<SampleRange> round{{0, track.tip.size() - 1}};
  CHECK(!inefficiency(round));
  CHECK(!inefficiency({}));
}

TEST_CASE("a change between rest and motion counts if it lasts more than 0.2 s") {
  std::vector<double> speed(60, 0.0);
  const auto set = [&](int from, int to, double v) {
    for (int i = from; i < to; ++i) speed[std::size_t(i)] = v;
  };
  speed.resize(240, 0.0);
  set(60, 100, 0.2);   // 0.67 s
  set(120, 130, 0.2);  // 0.17 s: too short
  set(140, 180, 0.2);
  set(160, 170, 0.0);  // a rest that is too short
  const std::vector<SampleRange> found = movements(speed, 1.0 / 60);
  REQUIRE(found.size() == 2);
  CHECK((found[0].first == 60 && found[0].last == 99));
  CHECK((found[1].first == 140 && found[1].last == 179));
  CHECK(movements(std::vector<double>(100, 0.049), 1.0 / 60).empty());
  CHECK(movements(std::vector<double>(100, 0.051), 1.0 / 60).size() == 1);
}

TEST_CASE("figures of forces, and times above a limit") {
  std::vector<double> force(40, 0.0);
  for (int i = 0; i < 20; ++i) force[std::size_t(10 + i)] = 1 + i;  // 1 to 20
  const ForceFigures figures = forceFigures(force);
  CHECK(figures.peak == 20);
  CHECK(figures.p95 == 19);
  CHECK(figures.mean == doctest::Approx(10.5));
  CHECK(figures.deviation == doctest::Approx(std::sqrt(399.0 / 12)));
  CHECK(forceFigures(std::vector<double>(5, 0.0)).peak == 0);
  force[35] = 9;
  const std::vector<SampleRange> errors = forceErrors(force, 8);
  REQUIRE(errors.size() == 2);
  CHECK((errors[0].first == 18 && errors[0].count() == 12));
  CHECK((errors[1].first == 35 && errors[1].count() == 1));
}

TEST_CASE("hands that speed up together correlate, and hands in turn do the opposite") {
  std::vector<double> a, b, turns;
  for (int i = 0; i < 100; ++i) {
    a.push_back(std::sin(0.1 * i));
    b.push_back(3 + 2 * std::sin(0.1 * i));
    turns.push_back(-std::sin(0.1 * i));
  }
  CHECK(*correlation(a, b) == doctest::Approx(1));
  CHECK(*correlation(a, turns) == doctest::Approx(-1));
  CHECK(!correlation(a, std::vector<double>(100, 1.0)));
  CHECK_THROWS_AS(correlation(a, std::vector<double>(3, 1.0)), Error);
}

TEST_CASE("learning curves") {
  CHECK(cusum(std::vector<double>{5, 4, 2}, 3) == std::vector<double>{2, 3, 2});
  const LearningTest test{0.3, 0.1, 0.7};
  const std::vector<double> curve = learningCusum({true, false, true, true, true}, test);
  const double win = std::log(0.9 / 0.7);
  CHECK(curve[0] == doctest::Approx(win));
  CHECK(curve[1] == 0);  // never below 0
  CHECK(curve[4] == doctest::Approx(3 * win));
  CHECK(*competentAt(curve, test) == 4);
  CHECK(!competentAt(std::vector<double>{0.1}, test));
  CHECK_THROWS_AS(learningCusum({true}, {0.1, 0.3, 1}), Error);
}

TEST_CASE("a tremor of 8 Hz and 0.3 mm changes the smoothness of a way, and hardly its length") {
  Track calm{1.0 / 60, {}, {}, Vec3::UnitZ()}, shaken = calm;
  for (int i = 0; i <= 120; ++i) {
    const double t = i / 120.0, s = t * t * t * (10 - 15 * t + 6 * t * t);  // minimum jerk
    calm.tip.push_back({0.3 * s, 0, 0});
    const double wave = 0.0003 * std::sin(2 * std::numbers::pi * 8 * i / 60.0);
    shaken.tip.push_back({0.3 * s, wave, 0.0003 * std::sin(2 * std::numbers::pi * 9 * i / 60.0)});
  }
  CHECK(pathLength(shaken.tip) < 1.05 * pathLength(calm.tip));
  const auto smooth = [](const Track& t) { return *logDimensionlessJerk(speeds(t), t.interval); };
  CHECK(smooth(shaken) < smooth(calm) - 0.5);
}
