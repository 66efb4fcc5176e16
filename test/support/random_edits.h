// Random edits, the same for the same seed.
#pragma once

#include <vector>

#include "base/random.h"
#include "sph/discretization.h"

namespace resect::test {

struct CellValue {
  std::int64_t cell;
  float value;
};

// One edit near a random particle of `cells`: a single cell, a rod, a ball or a slab of cells is
// emptied, or put back, or given random values.
inline std::vector<CellValue> randomEdit(const Discretization& cells, Random& random) {
  const Lattice& lattice = cells.lattice;
  std::int64_t seed = 0;
  do seed = std::int64_t(random.uniform() * double(lattice.cellCount()));
  while (!cells.inside[seed]);
  const Vec3i middle = lattice.cell(seed);
  Vec3i half = Vec3i::Zero();
  const int shape = random.below(4);
  if (shape == 1) half[random.below(3)] = 1 + random.below(6);
  if (shape == 2) half = Vec3i::Constant(1 + random.below(2));
  if (shape == 3) {
    half = Vec3i::Constant(2 + random.below(3));
    half[random.below(3)] = 0;
  }
  const int what = random.below(4);  // 0, 1: empty; 2: put back; 3: anything
  std::vector<CellValue> edit;
  for (int z = -half.z(); z <= half.z(); ++z)
    for (int y = -half.y(); y <= half.y(); ++y)
      for (int x = -half.x(); x <= half.x(); ++x) {
        const Vec3i c = middle + Vec3i(x, y, z);
        if (!lattice.contains(c)) continue;
        const std::int64_t i = lattice.index(c);
        const float anything = float(random.uniform(0, 100));
        edit.push_back({i, what == 3 ? anything : what == 2 ? cells.value[i] : 0.f});
      }
  return edit;
}

}  // namespace resect::test
