#include "operation/live/squeeze_speed.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace resect;

TEST_CASE("jaws go from wide open to closed and back in the time of a hand, at any frame rate") {
  for (const double rate : {60.0, 240.0, 1000.0}) {
    double squeeze = 0, time = 0;
    for (; squeeze < 1; time += 1 / rate) squeeze = squeezeTowards(1, squeeze, 1 / rate);
    CHECK(std::abs(time - kSqueezeTime) < 1.001 / rate);
    for (; squeeze > 0; time -= 1 / rate) squeeze = squeezeTowards(0, squeeze, 1 / rate);
    CHECK(std::abs(time) < 1.001 / rate);
  }
}

TEST_CASE("what is near is reached, and what is reached is kept") {
  CHECK(squeezeTowards(0.52, 0.5, 1.0 / 60) == 0.52);
  CHECK(squeezeTowards(0.5, 0.5, 1.0 / 60) == 0.5);
}
