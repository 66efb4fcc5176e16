#include "base/elementary.h"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <limits>

#include "base/random.h"

using namespace resect;

namespace {

// How far a value is from the true one, in units in the last place of the true one.
double unitsOff(double value, long double truth) {
  const double near = double(truth);
  const long double unit = (long double)(std::nextafter(std::abs(near), HUGE_VAL)) - std::abs(near);
  return double(std::abs((long double)(value)-truth) / unit);
}

// The most over so many random arguments in [low, high].
template <typename Ours, typename Truth>
double mostOff(Ours ours, Truth truth, double low, double high) {
  Random random(7);
  double most = 0;
  for (int i = 0; i < 200'000; ++i) {
    const double x = random.uniform(low, high);
    most = std::max(most, unitsOff(ours(x), truth((long double)(x))));
  }
  return most;
}

}  // namespace

TEST_CASE("sines and cosines are within two units in the last place") {
  for (const double reach : {1e-6, 0.8, 4.0, 100.0, 1e6}) {
    CAPTURE(reach);
    CHECK(mostOff(
              math::sin, [](long double x) { return std::sin(x); }, -reach, reach) < 2);
    CHECK(mostOff(
              math::cos, [](long double x) { return std::cos(x); }, -reach, reach) < 2);
  }
  // Next to multiples of a quarter turn, where nearly all cancels.
  double most = 0;
  for (int n = -500'000; n < 500'000; n += 7) {
    const double x = n * 1.5707963267948966;
    most = std::max(most, unitsOff(math::sin(x), std::sin((long double)(x))));
    most = std::max(most, unitsOff(math::cos(x), std::cos((long double)(x))));
  }
  CHECK(most < 2);
  CHECK(math::sin(0) == 0);
  CHECK(std::signbit(math::sin(-0.0)));
  CHECK(math::cos(0) == 1);
  CHECK(math::sin(5e-324) == 5e-324);
  CHECK(std::isnan(math::sin(1e7)));
  CHECK(std::isnan(math::cos(std::numeric_limits<double>::infinity())));
}

TEST_CASE("angles are within two units in the last place") {
  CHECK(mostOff(
            math::acos, [](long double x) { return std::acos(x); }, -1, 1) < 2);
  CHECK(mostOff(
            math::acos, [](long double x) { return std::acos(x); }, 1 - 1e-9, 1) < 2);
  CHECK(mostOff(
            math::acos, [](long double x) { return std::acos(x); }, -1, -1 + 1e-9) < 2);
  Random random(3);
  double most = 0;
  for (int i = 0; i < 400'000; ++i) {
    const double y = random.uniform() - 0.5, x = (random.uniform() - 0.5) * (i % 2 == 0 ? 1 : 1e-3);
    most =
        std::max(most, unitsOff(math::atan2(y, x), std::atan2((long double)(y), (long double)(x))));
    most =
        std::max(most, unitsOff(math::atan2(x, y), std::atan2((long double)(x), (long double)(y))));
  }
  CHECK(most < 2);
  const double pi = 3.141592653589793;
  CHECK(math::acos(-1) == pi);
  CHECK(math::acos(1) == 0);
  CHECK(math::atan2(0, 0) == 0);
  CHECK(math::atan2(0, -1) == pi);
  CHECK(math::atan2(-0.0, -1) == -pi);
  CHECK(math::atan2(1, 0) == pi / 2);
  CHECK(math::atan2(1, 1) == pi / 4);
  CHECK(std::isnan(math::acos(1.0000001)));
  CHECK(std::isnan(math::atan2(0, std::numeric_limits<double>::quiet_NaN())));
}

TEST_CASE("exponentials and cube roots are within two units in the last place") {
  for (const double reach : {1e-6, 0.4, 2.0, 50.0, 708.0}) {
    CAPTURE(reach);
    CHECK(mostOff(
              math::exp, [](long double x) { return std::exp(x); }, -reach, reach) < 2);
  }
  CHECK(math::exp(0) == 1);
  CHECK(math::exp(-800) == 0);
  CHECK(math::exp(800) == std::numeric_limits<double>::infinity());
  CHECK(std::isnan(math::exp(std::numeric_limits<double>::quiet_NaN())));
  for (const double reach : {1e-320, 1e-200, 1e-9, 8.0, 1e12, 1e308}) {
    CAPTURE(reach);
    CHECK(mostOff(
              math::cbrt, [](long double x) { return std::cbrt(x); }, -reach, reach) < 2);
  }
  CHECK(math::cbrt(0) == 0);
  CHECK(math::cbrt(27) == 3);
  CHECK(math::cbrt(-std::numeric_limits<double>::infinity()) ==
        -std::numeric_limits<double>::infinity());
}
