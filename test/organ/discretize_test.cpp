#include "organ/discretize.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "collision/inside.h"
#include "geometry/measures.h"
#include "geometry/primitives.h"
#include "sph/lattice_extent.h"
#include "support/references/mesh_reference.h"
#include "support/shared_data.h"

using namespace resect;

TEST_CASE("a spacing's lattice tiles the box from its lowest corner on") {
  const Lattice lattice = latticeForSpacing({{1, 2, 3}, {1.05, 2.051, 3.001}}, 0.01);
  CHECK(lattice.dims == Vec3i(5, 6, 1));
  CHECK(lattice.spacing == Vec3(0.01, 0.01, 0.01));
  CHECK(lattice.origin == Vec3(1.005, 2.005, 3.005));
}

TEST_CASE("the thesis's grid has its first sample at the corner and covers the box") {
  const Aabb box{{0, 0, 0}, {0.4, 0.2, 0.3}};
  const Lattice stretched = latticeForDims(box, {10, 10, 10});
  CHECK(stretched.origin == box.min);
  CHECK((stretched.spacing - Vec3(0.04, 0.02, 0.03)).norm() < 1e-15);
  CHECK(stretched.dims == Vec3i(11, 11, 11));
  const Lattice cubic = cubicLatticeForDims(box, 10);
  CHECK(cubic.cubic());
  CHECK(cubic.spacing.x() == doctest::Approx(0.04));
  CHECK(cubic.origin == box.min);
  CHECK(cubic.dims == Vec3i(11, 6, 8));
}

TEST_CASE("lattices are settled: their spacing is restored from their corners bit for bit") {
  for (const double spacing : {0.005, 0.0037, 0.001, 1.0 / 3, 0.012345678901234567})
    for (const Vec3& low : {Vec3(0, 0, 0), Vec3(-0.1327, 0.3498, 0.00078), Vec3(1e3, -7e-5, 3)}) {
      const Lattice a = latticeForSpacing({low, low + Vec3(0.2, 0.3, 0.1)}, spacing);
      CHECK(spacingBetween(a.origin, farCorner(a), a.dims) == a.spacing);
      CHECK(a.spacing.x() == doctest::Approx(spacing).epsilon(1e-11));
      const Lattice b = latticeForDims({low, low + Vec3(0.2, 0.3, 0.1)}, {10, 11, 13});
      CHECK(spacingBetween(b.origin, farCorner(b), b.dims) == b.spacing);
    }
  CHECK(latticeForSpacing({{-0.13, 0.35, 0.1}, {0.1, 0.5, 0.2}}, 0.005).spacing ==
        Vec3(0.005, 0.005, 0.005));
}

TEST_CASE("impossible lattices are refused in one sentence") {
  const Aabb box{{0, 0, 0}, {1, 1, 1}};
  CHECK_THROWS_AS(latticeForSpacing(box, 0), Error);
  CHECK_THROWS_AS(latticeForSpacing(box, -1), Error);
  CHECK_THROWS_AS(latticeForSpacing(box, std::nan("")), Error);
  CHECK_THROWS_AS(latticeForSpacing(box, 1e-6), Error);
  CHECK_THROWS_AS(latticeForSpacing({}, 0.1), Error);
  CHECK_THROWS_AS(latticeForDims(box, {10, 0, 10}), Error);
  CHECK_THROWS_AS(latticeForDims(box, {100000, 100000, 100000}), Error);
  CHECK_THROWS_AS(latticeForDims({{0, 0, 0}, {1, 1, 0}}, {10, 10, 10}), Error);
  CHECK_THROWS_AS(cubicLatticeForDims(box, 0), Error);
}

TEST_CASE("a box that fits its lattice fills its cells completely") {
  const Aabb box{{0, 0, 0}, {0.05, 0.03, 0.02}};
  const Discretization d = discretize(boxMesh(box), latticeForSpacing(box, 0.01));
  CHECK(d.particleCount() == 30);
  for (std::size_t i = 0; i < d.value.size(); ++i) CHECK(d.value[i] == 100);
  CHECK(d.volume() == doctest::Approx(volume(boxMesh(box))));
}

TEST_CASE("flags are the exact inside test, values the share of 64 samples") {
  const TriangleMesh mesh =
      transformed(torusMesh({0, 0, 0}, 0.05, 0.02),
                  {{0.01, 0, 0.02}, Eigen::Quaterniond(0.8, 0.3, 0.1, -0.4).normalized()});
  Lattice lattices[] = {latticeForSpacing(bounds(mesh), 0.007),
                        latticeForDims(bounds(mesh), {9, 12, 7}),
                        {{0, 0, 0}, {0.01, 0.01, 0.01}, {3, 4, 5}}};  // covers a part only
  for (const Lattice& lattice : lattices) {
    const Discretization d = discretize(mesh, lattice);
    std::vector<Vec3> centres, samples;
    for (std::int64_t c = 0; c < lattice.cellCount(); ++c) {
      centres.push_back(lattice.centre(lattice.cell(c)));
      for (int n = 0; n < 64; ++n)
        samples.push_back(
            centres.back() +
            lattice.spacing.cwiseProduct(Vec3(n % 4 - 1.5, n / 4 % 4 - 1.5, n / 16 - 1.5) / 4));
    }
    const auto centreInside = insideFlags(mesh, centres), sampleInside = insideFlags(mesh, samples);
    CHECK(d.inside == centreInside);
    for (std::size_t c = 0; c < centres.size(); ++c) {
      int filled = 0;
      for (int n = 0; n < 64; ++n) filled += sampleInside[64 * c + n];
      CHECK(d.value[c] == 100.0f / 64 * float(std::max<int>(filled, centreInside[c])));
    }
  }
}

TEST_CASE("the Visible Human liver has 13 114 particles at 5 mm and keeps its volume") {
  const auto path = test::sharedData("visible-human-male/VH_M_liver_closed.obj");
  if (!path) return;
  const TriangleMesh liver = test::readPlainObj(path->string());
  REQUIRE(liver.triangles.size() == 16898);
  const Discretization d = discretize(liver, latticeForSpacing(bounds(liver), 0.005));
  CHECK(d.particleCount() == 13114);
  CHECK(d.volume() == doctest::Approx(volume(liver)).epsilon(5e-4));
}

TEST_CASE("discretizing gives the same bits at 1, 2 and 3 threads") {
  const TriangleMesh mesh = sphereMesh({0, 0, 0}, 0.1, 40);
  const Lattice lattice = latticeForSpacing(bounds(mesh), 0.004);
  const auto at = [&](int threads) {
    const ThreadLimit limit(threads);
    return discretize(mesh, lattice);
  };
  const Discretization one = at(1);
  for (const int threads : {2, 3}) {
    const Discretization again = at(threads);
    CHECK(one.value == again.value);
    CHECK(one.inside == again.inside);
  }
}

TEST_CASE("progress rises from 0 to 1 and can cancel") {
  const TriangleMesh mesh = sphereMesh({0, 0, 0}, 0.1, 10);
  const Lattice lattice = latticeForSpacing(bounds(mesh), 0.02);
  std::vector<double> shares;
  discretize(mesh, lattice, [&](double share) {
    shares.push_back(share);
    return true;
  });
  CHECK(shares.front() == 0);
  CHECK(shares.back() == 1);
  CHECK(std::is_sorted(shares.begin(), shares.end()));
  CHECK_THROWS_AS(discretize(mesh, lattice, [](double share) { return share < 0.4; }), Cancelled);
}
