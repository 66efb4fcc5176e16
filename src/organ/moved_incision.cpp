#include "organ/moved_incision.h"

#include <algorithm>

#include "surface/node_places.h"

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

// May the blade meet one of the brick's edges? Particles in and beside the brick lie round its
// nodes, which stray less than a spacing from them.
bool mayMeet(const Organ& organ, const TissueModel& tissue, const SweptBlade& blade,
             const Vec3i& brick) {
  const Lattice& lattice = organ.rest.lattice;
  const int refine = organ.field.refine();
  const double slack = lattice.spacing.maxCoeff();
  // Cell c lies at node refine * (c + 2).
  const Vec3i low = (kBrickNodes * brick / refine - Vec3i::Constant(3)).cwiseMax(0);
  const Vec3i end = kBrickNodes * (brick + Vec3i::Ones()) + Vec3i::Constant(refine - 1);
  const Vec3i high = (end / refine - Vec3i::Ones()).cwiseMin(lattice.dims - Vec3i::Ones());
  std::vector<Vec3> places;
  for (int z = low.z(); z <= high.z(); ++z)
    for (int y = low.y(); y <= high.y(); ++y)
      for (int x = low.x(); x <= high.x(); ++x) {
        const std::int64_t cell = lattice.index({x, y, z});
        if (organ.alive[cell] && organ.rest.inside[cell])
          places.push_back(lattice.centre({x, y, z}) + tissue.displacement(cell));
      }
  // Is there a place on the far side, or nearly?
  const auto reaches = [&](const Vec3& along, const Vec3& from, double most) {
    const double enough = most - slack * along.norm();
    return std::ranges::any_of(places,
                               [&](const Vec3& p) { return along.dot(p - from) >= enough; });
  };
  return std::ranges::any_of(blade.triangles, [&](const BladeTriangle& t) {
    return reaches(t.normal, t.corner, 0) && reaches(-t.normal, t.corner, 0) &&
           reaches(t.alongU, t.corner, 0) && reaches(t.alongV, t.corner, 0) &&
           reaches(-(t.alongU + t.alongV), t.corner, -1);
  });
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
  std::vector<std::int64_t> bricks = bricksRound(organ, nearCells);
  std::erase_if(bricks, [&](std::int64_t brick) {
    return !mayMeet(organ, tissue, blade, organ.field.brick(brick));
  });
  return incise(organ, blade, bricks,
                [&](const Vec3i& brick, std::span<Vec3, kPlacedNodes> places) {
                  placeNodes(organ.field, wound, organ.surface.iso(), brick, motionOf, places);
                });
}

}  // namespace resect
