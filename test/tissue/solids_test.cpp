// Bars, plates and blocks against elasticity theory.
#include <doctest/doctest.h>

#include "support/figures.h"
#include "support/references/relax.h"
#include "support/tissue_blocks.h"

using namespace resect;
using test::material;
using test::solidBlock;

namespace {

constexpr double kSolidSpacing = 0.005;
// Where a single held layer of cells acts as a wall: so many spacings inside the layer's centres
// (measured by the test of the hanging bar; its gradients are one-sided).
constexpr double kWall = 0.33;

}  // namespace

TEST_CASE("a square bar twists as Saint-Venant's does") {
  test::Figures figures("torsion");
  const int n = 8, length = 4 * n;
  const TissueMaterial m = material(5000, 0.3);
  ElasticTissue tissue(solidBlock({length, n, n}, kSolidSpacing, m), test::weightless());
  const Vec3 middle = tissue.lattice().box().centre();
  const auto fromAxis = [&](const Vec3i& at) { return Vec3(tissue.lattice().centre(at) - middle); };
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
    const Vec3 x = fromAxis(at);
    const double angle = 0.02 * x.x() / (length * kSolidSpacing);
    tissue.setDisplacement(c, {0, -angle * x.z(), angle * x.y()});
    if (at.x() == 0 || at.x() == length - 1) tissue.hold(c, kHeldY | kHeldZ);  // free to warp
  });
  CHECK(test::relax(tissue) < 40000);
  tissue.evaluateForces();
  double torque = 0, turn = 0, weight = 0;
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
    const Vec3 x = fromAxis(at), u = tissue.displacement(c), f = tissue.elasticForce(c);
    if (at.x() == 0) torque += x.y() * f.z() - x.z() * f.y();
    const int half = at.x() == length / 2 - n / 2 ? -1 : at.x() == length / 2 + n / 2 ? 1 : 0;
    turn += half * (x.y() * u.z() - x.z() * u.y());
    if (half > 0) weight += x.tail<2>().squaredNorm();
  });
  const double rate = turn / weight / (n * kSolidSpacing);
  const double expected = 0.140577 * m.shear() * rate * std::pow(n * kSolidSpacing, 4);
  CHECK(figures.add("torque at 8 x 8 cells (N m)", std::abs(torque), expected, 0.03) < 0.03);
}

TEST_CASE("a slit opens under tension as fracture mechanics says") {
  test::Figures figures("slit");
  // Plane strain; a slit of 12 cells in a plate of 48 x 96, pulled by a constant stress.
  const int half = 6, width = 8 * half, height = 16 * half;
  const double stress = 10;
  const TissueMaterial m = material(5000, 0.3);
  ElasticTissue tissue(solidBlock({width, height, 3}, kSolidSpacing, m), test::weightless());
  const double low = width / 2 - half - 0.5, high = width / 2 + half - 0.5;
  const auto above = [&](const Vec3i& at) { return at.y() >= height / 2; };
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
    tissue.hold(c, kHeldZ);
    if (at.y() == 0 || at.y() == height - 1)
      tissue.setLoad(c, {0, (at.y() ? stress : -stress) * kSolidSpacing * kSolidSpacing, 0});
    for (int d = 0; d < kDirections; ++d) {
      const double crossing = at.x() + 0.5 * offsetAlong(d, 0);
      if (above(at) != above(at + offsetOf(d)) && crossing > low && crossing < high)
        tissue.sever(c, d);
    }
  });
  CHECK(test::relax(tissue, 1e-6) < 40000);
  double opening = 0;
  int count = 0;
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
    if (at.x() != width / 2 && at.x() != width / 2 - 1) return;
    if (at.y() == height / 2) opening += tissue.displacement(c).y(), ++count;
    if (at.y() == height / 2 - 1) opening -= tissue.displacement(c).y();
  });
  // Opening at the middle of a central slit in a strip, Tada, Paris, Irwin (1973); a / b = 1 / 4.
  const double r = 0.25;
  const double strip = -0.071 - 0.535 * r + 0.169 * r * r + 0.09 * r * r * r +
                       0.02 * r * r * r * r - 1.071 / r * std::log(1 - r);
  const double expected =
      4 * stress * half * kSolidSpacing / (m.young / (1 - m.poisson * m.poisson)) * strip;
  CHECK(figures.add("opening of a slit of 12 cells (m)", opening / count, expected, 0.05) < 0.05);
}

TEST_CASE(
    "a bar stretches under its own weight as theory says; a held layer is a wall a third of a "
    "cell inside") {
  test::Figures figures("own weight");
  const TissueMaterial m = material(5000, 0.3);
  const double g = 0.5;
  const int n = 30;
  // Without a wall: two bars end to end, pulled apart by weights in opposite directions.
  {
    ElasticTissue tissue(solidBlock({2 * n + 1, 5, 5}, kSolidSpacing, m), test::weightless());
    test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
      const int side = (at.x() > n) - (at.x() < n);
      tissue.setLoad(c, {side * tissue.mass(c) * g, 0, 0});
    });
    CHECK(test::relax(tissue) < 40000);
    double tip = 0;
    test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
      if (at.x() == 2 * n) tip += tissue.displacement(c).x() / 50;
      if (at.x() == 0) tip -= tissue.displacement(c).x() / 50;
    });
    // Stress from the middle out to the end face, which is half a cell beyond the last centre.
    const double x = n * kSolidSpacing, face = x + kSolidSpacing / 2;
    const double expected = m.density * g / m.young * (face * x - x * x / 2);
    CHECK(figures.add("tip, no wall (m)", tip, expected, 0.01) < 0.01);
  }
  // Hung up by its first layer.
  {
    TissueSettings settings;
    settings.gravity = {g, 0, 0};
    ElasticTissue tissue(solidBlock({n, 5, 5}, kSolidSpacing, material(5000, 0)), settings);
    test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
      if (at.x() == 0) tissue.hold(c, kHeldX);
    });
    CHECK(test::relax(tissue) < 40000);
    const double tip = tissue.displacement(tissue.lattice().index({n - 1, 2, 2})).x();
    const double x = (n - 1 - kWall) * kSolidSpacing, face = x + kSolidSpacing / 2;
    const double expected = m.density * g / m.young * (face * x - x * x / 2);
    CHECK(figures.add("tip, if the wall is 0.33 spacings inside (m)", tip, expected, 0.01) < 0.01);
  }
}

TEST_CASE("Cook's membrane") {
  test::Figures figures("cook");
  // E = 1, nu = 1/3, plane stress: under a shear of 1 per unit of thickness the middle of the free
  // end rises by 23.96 (Cook 1974, converged). Here a thin plate of three layers, edges in steps.
  const int columns = 32;
  const double s = 48 / (columns - 1 - kWall + 0.5);
  TissueCells cells = solidBlock({columns, int(62 / s), 3}, s, material(1, 1.0 / 3));
  for (std::int64_t c = 0; c < cells.lattice.cellCount(); ++c) {
    const Vec3i at = cells.lattice.cell(c);
    const double x = (at.x() - kWall) * s, y = (at.y() + 0.5) * s;
    const double along = std::max(0.0, x) / 48;
    cells.solid[c] = y > 44 * along && y < 44 + 16 * along;
  }
  ElasticTissue tissue(cells, test::weightless());
  int ends = 0;
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
    if (at.x() == 0) tissue.hold(c, kHeldAll);
    ends += at.x() == columns - 1;
  });
  const double force = 1e-3;
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
    if (at.x() == columns - 1) tissue.setLoad(c, {0, force * 3 * s / ends, 0});
  });
  CHECK(test::relax(tissue, 1e-6) < 40000);
  double rise = 0;
  int middle = 0;
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
    if (at.x() == columns - 1 && std::abs((at.y() + 0.5) * s - 52) <= 0.75 * s)
      rise += tissue.displacement(c).y(), ++middle;
  });
  CHECK(figures.add("rise of the free end's middle", rise / middle / force, 23.96, 0.05) < 0.05);
}

TEST_CASE("a hanging cube sags the same at 10 and at 100 thousand particles") {
  test::Figures figures("resolution");
  const double side = 0.1;
  const auto sag = [&](int n) {
    const double s = side / (n - kWall - 0.5);
    TissueSettings settings;
    settings.gravity = {0, 0, -2};
    ElasticTissue tissue(solidBlock(Vec3i::Constant(n), s, material(5000, 0.45)), settings);
    test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
      if (at.z() == n - 1) tissue.hold(c, kHeldAll);
    });
    CHECK(test::relax(tissue, 1e-5) < 40000);
    double sum = 0;
    test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
      if (at.z() == 0) sum -= tissue.displacement(c).z() / (n * n);
    });
    return sum;
  };
  const double coarse = sag(22), fine = sag(46);
  CHECK(figures.add("sag (m), 10 648 particles against 97 336", coarse, fine, 0.03) < 0.03);
}
