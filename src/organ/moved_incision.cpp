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

// How the particles have moved; each is asked once.
class Motions {
 public:
  Motions(const Organ& organ, const TissueModel& tissue)
      : lattice_(organ.rest.lattice), tissue_(tissue), known_(lattice_.cellCount(), -1) {}

  const ParticleMotion& of(std::int64_t cell) {
    if (known_[cell] < 0) {
      CellPlacement place;
      tissue_.place({&cell, 1}, {&place, 1});
      known_[cell] = std::int32_t(motions_.size());
      motions_.push_back({lattice_.centre(lattice_.cell(cell)) + place.displacement.cast<double>(),
                          Mat3::Identity() + place.gradient.cast<double>()});
    }
    return motions_[known_[cell]];
  }

 private:
  const Lattice& lattice_;
  const TissueModel& tissue_;
  std::vector<std::int32_t> known_;
  std::vector<ParticleMotion> motions_;
};

// Bounds of where the nodes of a brick are now. A node lies among the places that the particles of
// its lattice cube take it to; beside a cut some follow particles farther away.
class BrickPlaces {
 public:
  BrickPlaces(const Organ& organ, const TissueModel& tissue, Motions& motions, const Vec3i& brick)
      : organ_(organ), tissue_(tissue), motions_(motions), brick_(brick) {
    list(organ.severed.near(organ.field.brickIndex(brick)) ? 1 : 0);
    if (particles_.empty()) list(1);
  }

  // From the particles' places alone: however stretched, no node strays two spacings from them.
  Aabb rough() const {
    Aabb box;
    const Lattice& lattice = organ_.rest.lattice;
    for (const std::int64_t p : particles_)
      box.grow(Vec3(lattice.centre(lattice.cell(p)) + tissue_.displacement(p)));
    return widened(box, 2.0);
  }
  // From where each particle takes the whole brick.
  Aabb close() const {
    const ColourField& field = organ_.field;
    const Vec3 first = field.nodePosition((kBrickNodes * brick_).cast<double>());
    const Vec3 half = 0.5 * kBrickNodes * field.lattice().spacing / field.refine();
    const Lattice& lattice = organ_.rest.lattice;
    Aabb box;
    for (const std::int64_t p : particles_) {
      const ParticleMotion& motion = motions_.of(p);
      const Vec3 arm = first + half - lattice.centre(lattice.cell(p));
      const Vec3 middle = motion.position + motion.gradient * arm;
      const Vec3 reach = motion.gradient.cwiseAbs() * half;
      box.grow(Vec3(middle - reach));
      box.grow(Vec3(middle + reach));
    }
    return widened(box, 0.25);
  }

 private:
  // At the corners of the cubes that hold the brick's nodes, and `more` beyond.
  void list(int more) {
    const int refine = organ_.field.refine();
    const Lattice& lattice = organ_.rest.lattice;
    const Vec3i end = kBrickNodes * (brick_ + Vec3i::Ones()) + Vec3i::Constant(refine - 1);
    // Cell c lies at node refine * (c + 2).
    const Vec3i low = (kBrickNodes * brick_ / refine - Vec3i::Constant(2 + more)).cwiseMax(0);
    const Vec3i high =
        (end / refine - Vec3i::Constant(2 - more)).cwiseMin(lattice.dims - Vec3i::Ones());
    for (int z = low.z(); z <= high.z(); ++z)
      for (int y = low.y(); y <= high.y(); ++y)
        for (int x = low.x(); x <= high.x(); ++x) {
          const std::int64_t cell = lattice.index({x, y, z});
          if (organ_.alive[cell] && organ_.rest.inside[cell]) particles_.push_back(cell);
        }
  }
  Aabb widened(const Aabb& box, double spacings) const {
    const Vec3 slack = Vec3::Constant(spacings * organ_.rest.lattice.spacing.maxCoeff());
    return {box.min - slack, box.max + slack};
  }

  const Organ& organ_;
  const TissueModel& tissue_;
  Motions& motions_;
  Vec3i brick_;
  std::vector<std::int64_t> particles_;
};

}  // namespace

std::int64_t inciseMoved(Organ& organ, const TissueModel& tissue, const SweptBlade& blade,
                         std::span<const std::int64_t> nearCells) {
  if (blade.empty() || nearCells.empty()) return 0;
  Motions motions(organ, tissue);
  const auto motionOf = [&](std::int64_t cell) -> const ParticleMotion& {
    return motions.of(cell);
  };
  const Wound wound{organ.severed, organ.alive};
  std::vector<std::int64_t> bricks = bricksRound(organ, nearCells);
  std::erase_if(bricks, [&](std::int64_t index) {
    const BrickPlaces brick(organ, tissue, motions, organ.field.brick(index));
    return intersection(brick.rough(), blade.bounds).empty() ||
           intersection(brick.close(), blade.bounds).empty();
  });
  return incise(organ, blade, bricks,
                [&](const Vec3i& brick, std::span<Vec3, kPlacedNodes> places) {
                  placeNodes(organ.field, wound, organ.surface.iso(), brick, motionOf, places);
                });
}

}  // namespace resect
