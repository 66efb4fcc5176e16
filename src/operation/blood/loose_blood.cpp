#include "operation/blood/loose_blood.h"

#include <algorithm>

namespace resect {

std::shared_ptr<const LooseBlood> looseBlood(const Bleeding& blood) {
  if (blood.table().wet().empty() && blood.drops().empty()) return {};
  auto loose = std::make_shared<LooseBlood>();
  loose->pool.assign(std::size_t(kTableCells) * kTableCells, 0);
  for (const TablePatch& patch : blood.table().wet()) {
    const double depth = toCubicMetres(patch.volume) / (kTableCell * kTableCell);
    loose->pool[std::size_t(patch.number)] =
        std::uint8_t(std::clamp(255 * depth / LooseBlood::kDeepest + 0.5, 1.0, 255.0));
    loose->poolBox.grow(BloodTable::middleOf(patch.number));
  }
  if (!loose->poolBox.empty()) loose->poolBox = loose->poolBox.padded(2 * kTableCell);
  for (const BloodDrop& drop : blood.drops()) loose->drops.push_back(drop.place.cast<float>());
  return loose;
}

}  // namespace resect
