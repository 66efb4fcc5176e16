#include "organ/tissue_cells.h"

#include <algorithm>

#include "organ/organ.h"
#include "tissue/stencil.h"

namespace resect {

TissueCells tissueCells(const Discretization& rest, const TissueMaterial& material) {
  TissueCells cells{rest.lattice, rest.inside, {material}, {}};
  const auto count = std::size_t(rest.lattice.cellCount());
  cells.share.assign(count, 0.0f);
  cells.owner.assign(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const auto cell = std::int64_t(i);
    const double share = rest.cellVolume(cell) / rest.lattice.cellVolume();
    cells.share[i] = float(std::clamp(share, 0.0, 1.0));
    if (rest.inside[i] || !(share > 0)) continue;
    const std::int64_t owner = ownerCell(rest, cell);
    if (owner != cell)
      cells.owner[i] =
          std::uint8_t(1 + directionTo(rest.lattice.cell(owner) - rest.lattice.cell(cell)));
  }
  return cells;
}

}  // namespace resect
