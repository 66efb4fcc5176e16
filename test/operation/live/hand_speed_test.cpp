#include "operation/live/hand_speed.h"

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

TEST_CASE("a hand reaches its place, smoothly and no faster than it may, at any frame rate") {
  const Pose wanted{Vec3(0.1, 0.02, 0), rotationAbout(Vec3::UnitY(), 2.0)};
  for (const double rate : {30.0, 60.0, 1000.0}) {
    CAPTURE(rate);
    Pose now;
    double time = 0;
    for (; time < 5 && (now.position - wanted.position).norm() > 0; time += 1 / rate) {
      const Pose next = poseTowards(wanted, now, 1 / rate, 0.3);
      CHECK((next.position - now.position).norm() < 0.3 / rate + 1e-12);
      CHECK(angleBetween(next.rotation, now.rotation) < kHandTurning / rate + 1e-6);
      now = next;
    }
    CHECK(time > 0.102 / 0.3);
    CHECK(time < 1);
    CHECK(angleBetween(now.rotation, wanted.rotation) < 1e-6);
  }
}
