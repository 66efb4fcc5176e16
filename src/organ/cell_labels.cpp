#include "organ/cell_labels.h"

#include "base/error.h"
#include "organ/organ.h"

namespace resect {

std::int64_t markCells(Discretization& cells, int label, const Region& region) {
  require(label >= 0 && label <= 255, "label {} was asked for; give 0 to 255", label);
  requireSound(cells);
  const Lattice& lattice = cells.lattice;
  cells.label.resize(std::size_t(lattice.cellCount()), 0);
  std::int64_t marked = 0;
  for (std::int64_t cell = 0; cell < lattice.cellCount(); ++cell) {
    if (!cells.inside[std::size_t(cell)] && !(cells.value[std::size_t(cell)] > 0)) continue;
    if (!region.holds(lattice.centre(lattice.cell(cell)))) continue;
    cells.label[std::size_t(cell)] = std::uint8_t(label);
    marked += cells.inside[std::size_t(cell)];
  }
  return marked;
}

void labelSkin(Discretization& cells) {
  if (cells.label.empty()) return;
  for (std::int64_t cell = 0; cell < cells.lattice.cellCount(); ++cell)
    if (!cells.inside[std::size_t(cell)] && cells.value[std::size_t(cell)] > 0)
      cells.label[std::size_t(cell)] = cells.label[std::size_t(ownerCell(cells, cell))];
}

std::array<std::int64_t, 256> labelledParticles(const Discretization& cells) {
  std::array<std::int64_t, 256> count{};
  for (std::int64_t cell = 0; cell < cells.lattice.cellCount(); ++cell)
    count[cells.labelOf(cell)] += cells.inside[std::size_t(cell)];
  return count;
}

void carryLabels(const Discretization& from, Discretization& to) {
  to.labelNames = from.labelNames;
  to.landmarks = from.landmarks;
  if (from.label.empty()) return;
  to.label.assign(std::size_t(to.lattice.cellCount()), 0);
  for (std::int64_t cell = 0; cell < to.lattice.cellCount(); ++cell) {
    if (!to.inside[std::size_t(cell)]) continue;
    const Vec3 place = from.lattice.toCellSpace(to.lattice.centre(to.lattice.cell(cell)));
    const Vec3i old = place.array().round().cast<int>();
    if (from.lattice.contains(old))
      to.label[std::size_t(cell)] = from.label[std::size_t(from.lattice.index(old))];
  }
  labelSkin(to);
}

}  // namespace resect
