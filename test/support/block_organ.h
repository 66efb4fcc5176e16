// Small organs for tests: lattices filled by a rule, with no mesh needed.
#pragma once

#include <cmath>

#include "base/random.h"
#include "sph/discretization.h"

namespace resect::test {

// A cubic lattice of spacing s, m; cell values by value(cell) in [0, 100]; cells of 50 and more are
// particles.
template <typename Value>
Discretization fill(const Vec3i& dims, double s, Value value) {
  Discretization d;
  d.lattice.origin = Vec3(0.01, -0.02, 0.03);
  d.lattice.spacing = Vec3::Constant(s);
  d.lattice.dims = dims;
  d.value = ColourValues(std::size_t(d.lattice.cellCount()));
  for (std::int64_t i = 0; i < d.lattice.cellCount(); ++i) {
    const float v = float(value(d.lattice.cell(i)));
    d.value.set(std::size_t(i), v);
    d.inside.push_back(v >= 50);
  }
  return d;
}

inline Discretization fullBlock(const Vec3i& dims, double s = 0.005) {
  return fill(dims, s, [](const Vec3i&) { return 100.0; });
}

// A ball that fills the lattice up to one cell, with fractional values in its skin.
inline Discretization ball(int cells, double s = 0.005) {
  const double radius = 0.5 * cells - 1;
  return fill(Vec3i::Constant(cells), s, [&](const Vec3i& c) {
    const double r = (c.cast<double>() - Vec3::Constant(0.5 * (cells - 1))).norm();
    return 100 * std::clamp(radius - r + 0.5, 0.0, 1.0);
  });
}

// Every cell on its own: 0, 100 or something between.
inline Discretization noise(const Vec3i& dims, std::uint64_t seed, double s = 0.005) {
  Random random(seed);
  return fill(dims, s, [&](const Vec3i&) {
    const double u = random.uniform();
    return u < 0.4 ? 0.0 : u < 0.8 ? 100.0 : 100 * random.uniform();
  });
}

}  // namespace resect::test
