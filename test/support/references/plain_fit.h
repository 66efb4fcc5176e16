// The colour values that fitSurface() finds, with every weight evaluated where it is needed.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "organ/fit_surface.h"
#include "sph/colour_field.h"
#include "sph/kernel.h"

namespace resect::test {

inline std::vector<float> plainFit(const TriangleMesh& mesh, const Discretization& cells) {
  const Lattice& lattice = cells.lattice;
  const std::vector<Vec3> points = pointsToFit(mesh, lattice);
  const auto forEachCellNear = [&](const Vec3& p, auto visit) {
    for (std::int64_t i = 0; i < lattice.cellCount(); ++i) {
      const double r = (p - lattice.cell(i).cast<double>()).norm();
      if (r < 2) visit(std::size_t(i), kernel(r, kSmoothingPerSpacing));
    }
  };
  std::vector<float> value(cells.value.size());
  for (std::size_t i = 0; i < value.size(); ++i) value[i] = cells.value[i];
  const std::vector<float> before = value;
  for (int round = 0; round < 6; ++round) {
    std::vector<float> change(value.size()), weight(value.size());
    for (const Vec3& p : points) {
      double field = 0;
      forEachCellNear(p, [&](std::size_t i, double w) { field += w * value[i]; });
      forEachCellNear(p, [&](std::size_t i, double w) {
        change[i] += float(w * (50 - field));
        weight[i] += float(w);
      });
    }
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (before[i] <= 0 || before[i] >= 100 || !(weight[i] > 0)) continue;
      const double trust = std::min(1.0, weight[i] / 0.6);
      value[i] = std::clamp(value[i] + float(2 * trust * change[i] / weight[i]), 2 * kLevel,
                            100 - 2 * kLevel);
    }
  }
  for (std::size_t i = 0; i < value.size(); ++i)
    if (before[i] > 0 && before[i] < 100) value[i] = kLevel * std::round(value[i] / kLevel);
  return value;
}

}  // namespace resect::test
