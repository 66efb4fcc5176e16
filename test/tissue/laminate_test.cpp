// Two materials in a bar, one behind the other and side by side. Held layers of cells act like
// walls a third of a cell beyond their centres (docs/validation.md, "own weight").
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "support/figures.h"
#include "support/references/relax.h"
#include "support/tissue_blocks.h"

using namespace resect;

namespace {

constexpr int kAcross = 6;                                               // cells
constexpr double kSide = 0.005, kStretch = 1e-3, kBeforeHeld = 1.0 / 3;  // m, 1, cells

// Force that stretches a bar of liver and of a material `ratio` times as stiff, N. second: whether
// a cell is of the stiff material.
template <typename Second>
double pull(int length, Second second, double ratio = 13, int across = kAcross) {
  TissueCells cells = test::solidBlock({length, across, across}, kSide, test::material(5000, 0));
  cells.materials.push_back(test::material(5000 * ratio, 0));
  for (std::int64_t c = 0; c < cells.lattice.cellCount(); ++c)
    cells.material.push_back(second(cells.lattice.cell(c)));
  ElasticTissue tissue(cells, test::weightless());
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
    tissue.setDisplacement(c, {kStretch * kSide * (at.x() - 0.5 * (length - 1)), 0, 0});
    if (at.x() == 0 || at.x() == length - 1) tissue.hold(c, kHeldX);
  });
  CHECK(test::relax(tissue, 1e-9) < 40000);
  tissue.evaluateForces();
  double force = 0;
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
    if (at.x() == 0) force += tissue.elasticForce(c).x();
  });
  return force;
}

// Strain between the walls.
double strain(int length) { return kStretch * (length - 1) / (length - 1 - 2 * kBeforeHeld); }

}  // namespace

TEST_CASE("two materials in a row or side by side are as stiff as they should be") {
  test::Figures figures("laminate");
  const double area = kAcross * kAcross * kSide * kSide;
  for (const auto& [length, ratio] : {std::pair(8, 13.0), std::pair(16, 13.0), std::pair(32, 13.0),
                                      std::pair(8, 3.0), std::pair(8, 100.0)}) {
    const double force = pull(
        length, [&](const Vec3i& at) { return at.x() >= length / 2; }, ratio);
    const double expected = 2 * strain(length) * area / (1 / 5000.0 + 1 / (5000 * ratio));
    MESSAGE(ratio << " times, " << length << " cells: " << force / expected);
    const std::string name = fmt::format("{} cells in a row, {} times as stiff (N)", length, ratio);
    CHECK(figures.add(name, force, expected, 0.04) < 0.04);
  }
  const double force = pull(8, [](const Vec3i& at) { return at.y() >= kAcross / 2; });
  const double expected = strain(8) * area * 35000;
  CHECK(figures.add("6 cells side by side (N)", force, expected, 0.01) < 0.01);
}

// A layer of one cell, and a joint that lies oblique, in steps: against a lattice three times as
// fine, in which every cell of the first is 27 cells.
TEST_CASE("thin layers and oblique joints are as stiff as on a finer lattice") {
  const auto layer = [](const Vec3i& at) { return at.x() == 4; };
  const auto oblique = [](const Vec3i& at) { return 2 * at.x() + at.y() - 2 >= 9; };
  const auto finer = [](auto second) {
    return [=](const Vec3i& at) { return second(Vec3i(at.x() / 3, at.y() / 3, at.z() / 3)); };
  };
  // Per length between the walls, and per area in cells of the finer lattice.
  const auto compared = [&](auto second) {
    const double coarse = pull(9, second) / strain(9) / (kAcross * kAcross);
    const double fine =
        pull(27, finer(second), 13, 3 * kAcross) / strain(27) / (9 * kAcross * kAcross);
    return coarse / fine;
  };
  const double thin = compared(layer), turned = compared(oblique);
  MESSAGE("layer: " << thin << ", oblique joint: " << turned);
  CHECK(std::abs(thin - 1) < 0.03);
  CHECK(std::abs(turned - 1) < 0.07);
}
