#include "sph/lattice.h"

#include <doctest/doctest.h>

#include <limits>

#include "base/random.h"

using namespace resect;

TEST_CASE("a point lies in the cell whose box holds it, and outside the lattice in none") {
  const Lattice lattice{Vec3(0.3, -0.2, 0.1), Vec3(0.005, 0.007, 0.004), Vec3i(5, 3, 8)};
  Random random(3);
  int inside = 0;
  for (int i = 0; i < 5000; ++i) {
    const Aabb around = lattice.box().padded(0.01);
    Vec3 point;
    for (int a = 0; a < 3; ++a) point[a] = random.uniform(around.min[a], around.max[a]);
    const auto cell = lattice.cellAt(point);
    REQUIRE(cell.has_value() == lattice.box().contains(point));
    if (!cell) continue;
    ++inside;
    const Vec3 off = (point - lattice.centre(*cell)).cwiseQuotient(lattice.spacing);
    CHECK(off.cwiseAbs().maxCoeff() <= 0.5 + 1e-9);
  }
  CHECK(inside > 300);
  CHECK_FALSE(lattice.cellAt(Vec3::Constant(1e300)));
  CHECK_FALSE(lattice.cellAt(Vec3::Constant(std::numeric_limits<double>::quiet_NaN())));
}
