#include <doctest/doctest.h>

#include <cmath>

#include "geometry/measures.h"
#include "support/references/wound_reference.h"

using namespace resect;

namespace {

// A lumpy ball of tissue, or nodes at random.
test::GridOrgan randomOrgan(Random& random, bool smooth) {
  const Vec3i dims(7 + random.below(5), 7 + random.below(5), 7 + random.below(5));
  test::GridOrgan organ(dims);
  const Vec3 middle = 0.5 * (dims - Vec3i::Ones()).cast<double>();
  const Vec3 wave(random.uniform(0.5, 1.2), random.uniform(0.5, 1.2), random.uniform(0.5, 1.2));
  const double radius = 0.5 * dims.minCoeff() - 2.2, lumps = random.uniform(0, 0.5);
  if (smooth)
    organ.fill([&](const Vec3i& n) {
      const Vec3 d = n.cast<double>() - middle;
      return 50 + 40 * (radius - d.norm() + lumps * std::sin(wave.dot(d) * 2));
    });
  else
    organ.fill([&](const Vec3i&) { return random.uniform(0, 100); });
  return organ;
}

// Severs edges at random, each with the probability p; those that reach outside only if wanted.
void severAtRandom(test::GridOrgan& organ, Random& random, double p, bool outsideToo) {
  const CutGrid grid = organ.view();
  for (int i = 0; i < organ.dims.prod(); ++i)
    for (int a = 0; a < 3; ++a) {
      if (grid.node(i)[a] + 1 >= organ.dims[a]) continue;
      const bool within = grid.inside(i) && grid.inside(i + grid.stride(a));
      if ((within || outsideToo) && random.uniform() < p)
        organ.severed[std::size_t(a)][std::size_t(i)] =
            float(random.uniform(kCutMargin, 1 - kCutMargin));
    }
}

}  // namespace

TEST_CASE(
    "any set of severed edges gives a closed, oriented, manifold surface that bridges nothing") {
  int inexact = 0, unbalanced = 0;
  double worst = 0, farthest = 0;
  for (int run = 0; run < 10000; ++run) {
    Random random(std::uint64_t(run) + 1);
    const bool smooth = run % 2 == 0, anyBits = run % 4 >= 2;
    test::GridOrgan organ = randomOrgan(random, smooth);
    const double p = std::pow(10, random.uniform(-2.7, 0));
    severAtRandom(organ, random, p, run % 3 != 0);
    const CutGrid grid = organ.view();
    // Any answer to "does the skin hold" must do; in half of the runs it is thrown.
    const std::uint64_t seed = random.next();
    const test::HoldsRule thrown = [&](int node, int axis) {
      return Random(seed + std::uint64_t(3 * node + axis)).below(2) == 0;
    };
    const test::WoundMesh surface = test::woundMesh(grid, anyBits ? thrown : test::HoldsRule{});
    INFO("run ", run);
    REQUIRE(test::wrongWith(surface.mesh) == "");
    if (!anyBits) REQUIRE(test::bridges(surface, grid) == 0);
    const double whole = volume(test::tableMesh(grid));
    const double change = std::abs(volume(surface.mesh) - whole);
    if (surface.unbalanced == 0) {
      worst = std::max(worst, change / std::max(whole, 1.0));
    } else {
      ++inexact;
      unbalanced += surface.unbalanced;
      farthest = std::max(farthest, change / surface.unbalanced);
      CHECK_FALSE(smooth);
    }
  }
  MESSAGE("largest relative change of volume ", worst, "; ", inexact, " runs with ", unbalanced,
          " loops out of balance, by up to ", farthest, " cells each");
  CHECK(worst < 1e-9);
}
