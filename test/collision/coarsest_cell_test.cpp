#include "collision/coarsest_cell.h"

#include <doctest/doctest.h>

#include "collision/wall_thickness.h"
#include "geometry/measures.h"
#include "geometry/primitives.h"
#include "geometry/rotation.h"

using namespace resect;

namespace {

TriangleMesh hollowBall(double radius, double wall) {
  TriangleMesh mesh = sphereMesh(Vec3::Zero(), radius, 48);
  TriangleMesh inner = sphereMesh(Vec3::Zero(), radius - wall, 48);
  flip(inner);
  append(mesh, inner);
  return mesh;
}

}  // namespace

TEST_CASE("the coarsest cells keep a wall, however the organ is turned, and follow its size") {
  for (const double angle : {0.0, 0.4, 1.3}) {
    const Eigen::Quaterniond turn = rotationAbout(Vec3(1, 2, -1).normalized(), angle);
    for (const double wall : {0.002, 0.004}) {
      const TriangleMesh ball = transformed(hollowBall(0.05, wall), {Vec3(1, 0, 2), turn});
      const double cell = coarsestCell(ball);
      CHECK(cell > 0.5 * wall);
      CHECK(cell < wall);
      CHECK(wallThickness(ball).lostAt(cell) <= kMostLostTissue);
      CHECK(wallThickness(ball).lostAt(1.1 * cell) > kMostLostTissue);
    }
  }
}

TEST_CASE("a solid organ has no walls, but enough particles to show its shape") {
  for (const double radius : {0.02, 0.05, 0.1}) {
    const TriangleMesh ball = sphereMesh(Vec3(0.3, 0, 0), radius, 32);
    const double cell = coarsestCell(ball);
    CHECK(volume(ball) / (cell * cell * cell) >= kFewestParticles);
    CHECK(volume(ball) / (cell * cell * cell) < 1.1 * kFewestParticles);
  }
}
