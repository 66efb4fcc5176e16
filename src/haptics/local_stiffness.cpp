#include "haptics/local_stiffness.h"

#include <cmath>
#include <numbers>

#include "base/elementary.h"

namespace resect {
namespace {

// Variance of a cell's splines, 1/4 s^2 along each axis, as the area of a square that has it.
constexpr double kSplineArea = 3;  // spacings^2
// Mindlin's stiffness is that of a contact in which nothing slides. Here some cells always do.
// Fitted to the simulation (test/haptics/local_model_test.cpp).
constexpr double kSticks = 0.65;
// Gripped cells lie at the surface: there is tissue on one side only. Fitted there too.
constexpr double kOneSide = 0.35;

double punchRadius(double area, double spacing) {
  return std::sqrt((area + kSplineArea * spacing * spacing) / std::numbers::pi);
}

}  // namespace

LocalModuli moduliWithin(const TissueMaterial& m, double time) {
  double growth = 1;
  for (const Relaxation& branch : m.branches)
    growth += branch.share * branch.time / time * (1 - math::exp(-time / branch.time));
  const double bulk = m.lame() + 2.0 / 3 * m.shear();  // does not relax
  const double shear = m.shear() * growth;
  const double poisson = (3 * bulk - 2 * shear) / (2 * (3 * bulk + shear));
  return {shear, poisson, 2 * shear / (1 - poisson)};
}

double pressedStiffness(const LocalModuli& m, double area, double spacing) {
  return 2 * m.plane * punchRadius(area, spacing);
}

double draggedStiffness(const LocalModuli& m, double area, double spacing) {
  return kSticks * 2 * (1 - m.poisson) / (2 - m.poisson) * pressedStiffness(m, area, spacing);
}

double heldStiffness(const LocalModuli& m, int cells, double spacing) {
  if (cells <= 0) return 0;
  const double radius = spacing * math::cbrt(3 * cells / (4 * std::numbers::pi));
  return kOneSide * 24 * std::numbers::pi * m.shear * (1 - m.poisson) / (5 - 6 * m.poisson) *
         radius;
}

}  // namespace resect
