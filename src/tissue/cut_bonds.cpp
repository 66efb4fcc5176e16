#include "tissue/cut_bonds.h"

#include "tissue/stencil.h"

namespace resect {

std::vector<TissueBond> crossedBonds(const TissueModel& tissue, const Lattice& lattice,
                                     const SweptBlade& blade) {
  std::vector<TissueBond> crossed;
  if (blade.empty()) return crossed;
  const double reach = lattice.spacing.maxCoeff();
  visitCellsIn(lattice, blade.bounds.padded(reach), [&](const Vec3i& at) {
    const std::int64_t cell = lattice.index(at);
    const std::uint32_t bonds = tissue.solid(cell) ? tissue.bonds(cell) : 0;
    for (int d = kFirstForward; d < kDirections; ++d)
      if (bonds >> d & 1 && crossing(blade, lattice.centre(at), lattice.centre(at + offsetOf(d))))
        crossed.push_back({cell, d});
  });
  return crossed;
}

}  // namespace resect
