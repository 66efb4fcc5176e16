#include "collision/wall_thickness.h"

#include <doctest/doctest.h>

#include "base/parallel.h"
#include "geometry/measures.h"
#include "geometry/primitives.h"
#include "organ/discretize.h"
#include "organ/fit_surface.h"
#include "organ/organ.h"

using namespace resect;

namespace {

TriangleMesh hollowBall(double radius, double wall) {
  const Vec3 centre(0.01, 0.02, -0.01);
  TriangleMesh mesh = sphereMesh(centre, radius, 32), inner = sphereMesh(centre, radius - wall, 32);
  flip(inner);
  append(mesh, inner);
  return mesh;
}

}  // namespace

TEST_CASE("plates, tubes and balls have their thickness") {
  const WallThickness plate = wallThickness(boxMesh({{0, 0, 0}, {0.1, 0.1, 0.004}}));
  CHECK(plate.ascending.size() > 1990);
  CHECK(plate.at(0.05) == doctest::Approx(0.004));
  CHECK(plate.at(0.9) == doctest::Approx(0.004));
  CHECK(plate.at(1) == doctest::Approx(0.1));  // its rim
  // Turned, so that it faces none of the 13 directions.
  const Eigen::Quaterniond turn = Eigen::Quaterniond(0.9, 0.1, 0.3, 0.2).normalized();
  const WallThickness turned =
      wallThickness(transformed(boxMesh({{0, 0, 0}, {0.1, 0.1, 0.004}}), {Vec3(1, 2, 3), turn}));
  CHECK(turned.at(0.5) == doctest::Approx(0.004));
  // A chord and the cosine of its angle, 29 degrees at most, are each a cosine of the diameter.
  const WallThickness ball = wallThickness(sphereMesh({0, 0, 0}, 0.03));
  CHECK(ball.at(0) > 0.75 * 0.06);
  CHECK(ball.at(1) < 0.0601);
  const WallThickness hollow = wallThickness(hollowBall(0.04, 0.002));
  CHECK(hollow.at(0.05) == doctest::Approx(0.002).epsilon(0.02));
  CHECK(hollow.at(0.5) == doctest::Approx(0.002).epsilon(0.01));
  CHECK(wallThickness(torusMesh({0, 0, 0}, 0.05, 0.01)).at(0.5) ==
        doctest::Approx(0.018).epsilon(0.1));
}

TEST_CASE("an organ has lost as much of its tissue as its walls foretell") {
  constexpr double kCell = 0.005;
  for (const double cells : {0.45, 0.55, 0.65, 0.75, 0.95, 1.5}) {
    CAPTURE(cells);
    const TriangleMesh mesh = hollowBall(0.041, cells * kCell);
    Discretization made = discretize(mesh, latticeForSpacing(bounds(mesh), kCell));
    fitSurface(mesh, made);
    const Organ organ = makeOrgan(std::move(made), {});
    const double kept = volume(organ.surface.mesh()) / volume(mesh);
    // How walls lie to the lattice changes what is kept, most where half is.
    CHECK(1 - wallThickness(mesh).lostAt(kCell) == doctest::Approx(kept).epsilon(0.12).scale(1));
  }
}

TEST_CASE("walls are measured alike at any number of threads") {
  const TriangleMesh mesh = hollowBall(0.04, 0.003);
  const auto measured = [&](int threads) {
    const ThreadLimit limit(threads);
    return wallThickness(mesh).ascending;
  };
  const std::vector<double> one = measured(1);
  CHECK(one == measured(2));
  CHECK(one == measured(3));
}

TEST_CASE("the cell that walls need keeps what is asked") {
  const WallThickness walls = wallThickness(hollowBall(0.04, 0.002));
  const double cell = walls.cellFor(0.02);
  CHECK(cell > 0.0015);
  CHECK(cell < 0.0018);
  CHECK(walls.lostAt(cell) <= 0.02);
  CHECK(walls.lostAt(cell + 1e-5) > 0.02);
  CHECK(wallThickness(sphereMesh({0, 0, 0}, 0.03)).lostAt(0.005) == 0);
  CHECK(WallThickness().lostAt(0.005) == 0);
  CHECK(WallThickness().at(0.5) == 0);
}
