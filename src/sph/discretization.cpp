#include "sph/discretization.h"

namespace resect {

void requireSound(const Discretization& cells) {
  const Lattice& lattice = cells.lattice;
  require(lattice.sound(),
          "a lattice of {} x {} x {} cells of {} x {} x {} m is none; give finite lengths above 0",
          lattice.dims.x(), lattice.dims.y(), lattice.dims.z(), lattice.spacing.x(),
          lattice.spacing.y(), lattice.spacing.z());
  const auto count = std::size_t(lattice.cellCount());
  require(
      cells.value.size() == count && cells.inside.size() == count &&
          (cells.label.empty() || cells.label.size() == count),
      "{} cells have {} colour values, {} flags and {} labels; give one of each for every cell, "
      "or no label",
      count, cells.value.size(), cells.inside.size(), cells.label.size());
}

}  // namespace resect
