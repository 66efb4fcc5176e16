#include "geometry/farthest_point.h"

#include <doctest/doctest.h>

#include "base/random.h"

using namespace resect;

namespace {

std::uint32_t plainFarthest(const std::vector<Vec3>& points, const Vec3& direction) {
  std::uint32_t best = 0;
  for (std::uint32_t i = 1; i < points.size(); ++i)
    if (direction.dot(points[i]) > direction.dot(points[best])) best = i;
  return best;
}

Vec3 randomVector(Random& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

}  // namespace

TEST_CASE("the farthest point is the one that a loop over all points finds first") {
  Random random(5);
  for (const double away : {0.0, 1e6}) {
    std::vector<Vec3> points;
    points.reserve(5040);
    for (int i = 0; i < 5000; ++i) points.push_back(Vec3::Constant(away) + randomVector(random));
    // Corners of a box, each several times: along an axis many are equally far.
    for (int i = 0; i < 40; ++i)
      points.push_back(Vec3::Constant(away) + Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
    const FarthestPoint farthest(points);
    for (int i = 0; i < 300; ++i) {
      const Vec3 d = i < 6 ? Vec3((i < 3 ? 1 : -1) * Vec3::Unit(i % 3)) : randomVector(random);
      REQUIRE(farthest.along(d) == plainFarthest(points, d));
    }
  }
}

TEST_CASE("a single point, and points of one plane, have a farthest one") {
  const std::vector<Vec3> one = {Vec3(1, 2, 3)};
  CHECK(FarthestPoint(one).along(Vec3(0, -1, 0)) == 0);
  const std::vector<Vec3> flat = {Vec3(0, 1, 0), Vec3(2, 1, 0), Vec3(1, 1, 3)};
  CHECK(FarthestPoint(flat).along(Vec3(1, 0, 0)) == 1);
  CHECK(FarthestPoint(flat).along(Vec3(0, 5, 1)) == 2);
}
