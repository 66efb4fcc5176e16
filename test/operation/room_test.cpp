#include "operation/room.h"

#include <doctest/doctest.h>

#include "geometry/measures.h"
#include "geometry/repair/mesh_health.h"

using namespace resect;

TEST_CASE("the walls of the tray are one closed frame round the tools") {
  const TriangleMesh walls = toolBoxWalls();
  CHECK(volume(walls) == doctest::Approx((0.3 * 0.22 - 0.276 * 0.196) * 0.025));
  const MeshHealth health = examine(walls);
  CHECK(health.closed);
  CHECK(health.oriented);
  CHECK_FALSE(health.insideOut);
  for (int tool = 0; tool < kToolBoxPlaces; ++tool) {
    const Vec3 place = toolBoxPose().inverse() * toolBoxPlace(tool).position;
    CHECK(std::abs(place.x()) < 0.15 - 0.012);
    CHECK(std::abs(place.z()) < 0.11 - 0.012);
  }
}

TEST_CASE("the fifth to twelfth tool lie in the tray, apart from each other") {
  for (int tool = kToolBoxPlaces; tool < 12; ++tool) {
    const Vec3 place = trayPose().inverse() * toolBoxPlace(tool).position;
    constexpr double kLongest = 0.19;  // m: test/models/models_test.py
    CHECK(std::abs(place.x()) < 0.102 - 0.02);
    CHECK(place.z() > -0.2);
    CHECK(place.z() + kLongest < 0.212 - 0.006);
    for (int other = kToolBoxPlaces; other < tool; ++other) {
      const Vec3 apart = toolBoxPlace(tool).position - toolBoxPlace(other).position;
      CHECK((std::abs(apart.x()) > 0.04 || std::abs(apart.z()) > kLongest));
    }
  }
}
