#include "inventor/hand/six_axes.h"

#include <doctest/doctest.h>

using namespace resect;

TEST_CASE("a cap that hardly moves moves nothing") {
  const ViewMotion motion = motionOf({Vec3(12, -12, 5), Vec3(-7, 0, 12)}, 0.02);
  CHECK(motion.move.isZero());
  CHECK(motion.turn.isZero());
}

TEST_CASE("a cap pushed to its end moves 7 cm in half a second, along the axis it is pushed") {
  Vec3 way = Vec3::Zero();
  for (int report = 0; report < 30; ++report)
    way += motionOf({Vec3(0, 0, -350), Vec3::Zero()}, 0.5 / 30).move;
  CHECK(way.z() == doctest::Approx(-0.0676));  // (350 - 12) counts of 0.4 mm/s
  CHECK(way.x() == 0);
  CHECK(way.y() == 0);
}

TEST_CASE("turning is told from pushing, and signs are kept") {
  const ViewMotion motion = motionOf({Vec3::Zero(), Vec3(112, -112, 0)}, 0.05);
  CHECK(motion.move.isZero());
  CHECK(motion.turn.x() == doctest::Approx(0.02));
  CHECK(motion.turn.y() == doctest::Approx(-0.02));
  CHECK(motion.turn.z() == 0);
}

TEST_CASE("after a long pause nothing jumps, and a clock that goes back does nothing") {
  CHECK(motionOf({Vec3(350, 0, 0), {}}, 60).move == motionOf({Vec3(350, 0, 0), {}}, 0.1).move);
  CHECK(motionOf({Vec3(350, 0, 0), {}}, -1).move.isZero());
}
