#include "operation/blood/loose_blood.h"

#include <algorithm>

#include "base/random.h"

namespace resect {
namespace {

// A drop of the simulation stands for a piece of a jet, which breaks up in the air: it is seen as
// droplets along the way that it makes in kExposure, about kApart from each other on average: close
// together at its head, sparse at its tail, where they have strayed from the way by up to kAside.
constexpr double kExposure = 1.0 / 60;  // s
constexpr double kApart = 0.0009;       // m
constexpr double kAside = 0.0015;       // m
constexpr int kMostPoints = 80;         // of one drop

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
  Random random(1);  // the same frame gives the same picture
  for (const BloodDrop& drop : blood.drops()) {
    const Vec3 way = kExposure * drop.velocity;
    const int points = std::min(1 + int(way.norm() / kApart), kMostPoints);
    for (int i = 0; i < points; ++i) {
      const double share = (i + random.uniform()) / points, back = share * share;
      const Vec3 aside(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      loose->drops.push_back(
          (drop.place - (points == 1 ? 0 : back) * way + back * kAside * aside).cast<float>());
    }
  }
  return loose;
}

}  // namespace resect
