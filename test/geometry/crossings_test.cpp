#include "geometry/repair/crossings.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/random.h"
#include "geometry/primitives.h"
#include "support/references/mesh_reference.h"

using namespace resect;

TEST_CASE("crossing numbers are the solid angles' winding numbers at random points") {
  TriangleMesh inverted = sphereMesh({3, 0, 0}, 1, 10);
  flip(inverted);
  TriangleMesh mesh = torusMesh({0, 0, 0}, 2, 0.7, 30, 15);
  append(mesh, inverted);
  append(mesh, boxMesh({{-1, -1, -1}, {2.5, 1, 1}}));  // overlaps both
  Random random(4);
  std::vector<Vec3> points;
  for (int i = 0; i < 500; ++i)
    points.emplace_back(random.uniform(-4, 5), random.uniform(-1.5, 1.5), random.uniform(-3, 3));
  const std::vector<int> numbers = crossingNumbers(mesh, points);
  int seen[4] = {0, 0, 0, 0};
  for (std::size_t i = 0; i < points.size(); ++i) {
    CHECK(numbers[i] == int(std::lround(test::solidAngleWinding(mesh, points[i]))));
    ++seen[numbers[i] + 1];
  }
  for (const int count : seen) CHECK(count > 0);  // -1, 0, 1 and 2 all occur
}

TEST_CASE("rays through edges and corners count once") {
  // From the lattice points of a box of lattice triangles, every ray meets edges or corners.
  const TriangleMesh box = boxMesh({{0, 0, 0}, {4, 4, 4}});
  std::vector<Vec3> points;
  for (int x = -1; x <= 5; x += 2)
    for (int y = -1; y <= 5; ++y)
      for (int z = -1; z <= 5; ++z) points.emplace_back(x, y, z);
  const std::vector<int> numbers = crossingNumbers(box, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3& p = points[i];
    const bool onRim = ((p.tail<2>().array() == 0) || (p.tail<2>().array() == 4)).any();
    if (onRim)
      CHECK((numbers[i] == 0 || numbers[i] == 1));
    else
      CHECK(numbers[i] == int(Aabb{{0, 0, 0}, {4, 4, 4}}.contains(p)));
  }
}

TEST_CASE("nothing goes round nothing") {
  CHECK(crossingNumbers({}, std::vector<Vec3>{{0, 0, 0}}) == std::vector<int>{0});
  CHECK(crossingNumbers(boxMesh({{0, 0, 0}, {1, 1, 1}}), {}).empty());
}
