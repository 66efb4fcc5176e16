#include "organ/moved_incision.h"

#include <algorithm>

#include "surface/node_places.h"
#include "tissue/stencil.h"

namespace resect {
namespace {

// The bricks that hold a node beside one of the cells, ascending.
std::vector<std::int64_t> bricksRound(const Organ& organ, std::span<const std::int64_t> cells) {
  const ColourField& field = organ.field;
  const Lattice& lattice = organ.rest.lattice;
  const Vec3 first = field.nodePosition(Vec3::Zero());
  const Vec3 step = field.nodePosition(Vec3::Ones()) - first;
  std::vector<std::int64_t> bricks;
  for (const std::int64_t cell : cells) {
    const Vec3 centre = lattice.centre(lattice.cell(cell));
    Vec3i low, high;
    for (int a = 0; a < 3; ++a) {
      const double reach = 1.01 * lattice.spacing[a];
      low[a] = std::max(0, int((centre[a] - reach - first[a]) / step[a]) / kBrickNodes);
      high[a] = std::min(field.brickDims()[a] - 1,
                         int((centre[a] + reach - first[a]) / step[a]) / kBrickNodes);
    }
    for (int z = low.z(); z <= high.z(); ++z)
      for (int y = low.y(); y <= high.y(); ++y)
        for (int x = low.x(); x <= high.x(); ++x) bricks.push_back(field.brickIndex({x, y, z}));
  }
  std::sort(bricks.begin(), bricks.end());
  bricks.erase(std::unique(bricks.begin(), bricks.end()), bricks.end());
  return bricks;
}

}  // namespace

std::int64_t inciseMoved(Organ& organ, const TissueModel& tissue, const SweptBlade& blade,
                         std::span<const std::int64_t> nearCells) {
  if (blade.empty() || nearCells.empty()) return 0;
  const Lattice& lattice = organ.rest.lattice;
  // Each particle is asked once.
  std::vector<std::int32_t> known(lattice.cellCount(), -1);
  std::vector<ParticleMotion> motions;
  const auto motionOf = [&](std::int64_t cell) -> const ParticleMotion& {
    if (known[cell] < 0) {
      CellPlacement place;
      tissue.place({&cell, 1}, {&place, 1});
      known[cell] = std::int32_t(motions.size());
      motions.push_back({lattice.centre(lattice.cell(cell)) + place.displacement.cast<double>(),
                         Mat3::Identity() + place.gradient.cast<double>()});
    }
    return motions[known[cell]];
  };
  const Wound wound{organ.severed, organ.alive};
  return incise(organ, blade, bricksRound(organ, nearCells),
                [&](const Vec3i& brick, std::span<Vec3, kPlacedNodes> places) {
                  placeNodes(organ.field, wound, organ.surface.iso(), brick, motionOf, places);
                });
}

std::int64_t tearSurface(Organ& organ, std::span<const TissueBond> torn) {
  const int refine = organ.field.refine();
  std::int64_t severed = 0;
  for (const TissueBond& bond : torn) {
    if (neighbourKind(bond.direction) != 1) continue;
    const Vec3i step = offsetOf(bond.direction), from = organ.rest.lattice.cell(bond.cell);
    const Vec3i low = from.cwiseMin(from + step);
    const int axis = step.x() != 0 ? 0 : step.y() != 0 ? 1 : 2;
    // The lower cell's centre is a node; the shared face lies half a cell above it.
    const Vec3i node = refine * (low + Vec3i::Constant(2)) + (refine / 2) * Vec3i::Unit(axis);
    const double share = refine % 2 == 0 ? 0 : 0.5;
    const Vec3i along = Vec3i::Unit((axis + 1) % 3), across = Vec3i::Unit((axis + 2) % 3);
    for (int i = -refine / 2; i <= refine / 2; ++i)
      for (int j = -refine / 2; j <= refine / 2; ++j)
        severed +=
            organ.severed.sever(node + i * along + j * across, axis, share, Vec3::Unit(axis));
  }
  return severed;
}

}  // namespace resect
