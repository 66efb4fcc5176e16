#include "operation/blood/loose_blood.h"

#include <algorithm>

namespace resect {
namespace {

// A drop is seen as the streak that it makes in kExposure, by points so far apart.
constexpr double kExposure = 1.0 / 60;  // s
constexpr double kApart = 0.0004;       // m
constexpr int kMostPoints = 150;        // of a streak

}  // namespace

std::shared_ptr<const LooseBlood> looseBlood(const Bleeding& blood) {
  if (blood.table().wet().empty() && blood.drops().empty()) return {};
  auto loose = std::make_shared<LooseBlood>();
  // A patch is as deep as its neighbours make it, so that puddles have slopes for borders, not
  // steps.
  std::vector<float> depth(std::size_t(kTableCells) * kTableCells, 0.0f);
  for (const TablePatch& patch : blood.table().wet()) {
    const auto deep = float(toCubicMetres(patch.volume) / (kTableCell * kTableCell));
    const int x = patch.number % kTableCells, z = patch.number / kTableCells;
    for (int j = std::max(z - 1, 0); j <= std::min(z + 1, kTableCells - 1); ++j)
      for (int i = std::max(x - 1, 0); i <= std::min(x + 1, kTableCells - 1); ++i)
        depth[std::size_t(j * kTableCells + i)] +=
            deep * (i == x ? 0.5f : 0.25f) * (j == z ? 0.5f : 0.25f);
    loose->poolBox.grow(BloodTable::middleOf(patch.number));
  }
  loose->pool.resize(depth.size());
  std::ranges::transform(depth, loose->pool.begin(), [](float d) {
    return std::uint8_t(std::min(255 * d / float(LooseBlood::kDeepest) + 0.5f, 255.0f));
  });
  if (!loose->poolBox.empty()) loose->poolBox = loose->poolBox.padded(2 * kTableCell);
  for (const BloodDrop& drop : blood.drops()) {
    const Vec3 way = kExposure * drop.velocity;
    const int points = std::min(1 + int(way.norm() / kApart), kMostPoints);
    for (int i = 0; i < points; ++i)
      loose->drops.push_back((drop.place - way * (double(i) / points)).cast<float>());
  }
  return loose;
}

}  // namespace resect
