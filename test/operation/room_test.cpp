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
