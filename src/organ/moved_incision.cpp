#include "organ/moved_incision.h"

#include <algorithm>
#include <array>

#include "base/index_box.h"
#include "surface/node_places.h"

namespace resect {
namespace {

// The bricks that hold a node beside one of the cells, ascending. cells: not none.
std::vector<std::int64_t> bricksRound(const Organ& organ, std::span<const std::int64_t> cells) {
  const ColourField& field = organ.field;
  const Lattice& lattice = organ.rest.lattice;
  const Vec3 reach = 1.01 * lattice.spacing;
  std::vector<IndexBox> boxes;
  Vec3i low = field.brickDims(), high = Vec3i::Zero();  // of all of them
  for (const std::int64_t cell : cells) {
    const Vec3 centre = lattice.centre(lattice.cell(cell));
    boxes.push_back(field.bricksIn({centre - reach, centre + reach}));
    low = low.cwiseMin(boxes.back().low);
    high = high.cwiseMax(boxes.back().low + boxes.back().dims);
  }
  const IndexBox all{low, (high - low).cwiseMax(0)};
  std::vector<std::uint8_t> wanted(all.count(), 0);
  for (const IndexBox& box : boxes)
    for (int z = 0; z < box.dims.z(); ++z)
      for (int y = 0; y < box.dims.y(); ++y)
        std::fill_n(wanted.begin() + all.index(box.low + Vec3i(0, y, z)), box.dims.x(), 1);
  std::vector<std::int64_t> bricks;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (wanted[i]) bricks.push_back(field.brickIndex(all.place(std::int32_t(i))));
  return bricks;
}

// The cells whose particles the nodes of some bricks may follow. bricks: not none.
IndexBox cellsRound(const Organ& organ, std::span<const std::int64_t> bricks) {
  Vec3i first = organ.field.brick(bricks[0]), last = first;
  for (const std::int64_t index : bricks) {
    first = first.cwiseMin(organ.field.brick(index));
    last = last.cwiseMax(organ.field.brick(index));
  }
  constexpr int kFar = 4;  // cells beside a brick: a search along a cut stays in its window
  const int refine = organ.field.refine();
  const Vec3i& end = organ.rest.lattice.dims;
  const Vec3i low = (kBrickNodes * first / refine - Vec3i::Constant(2 + kFar)).cwiseMax(0);
  const Vec3i high = kBrickNodes * (last + Vec3i::Ones()) / refine + Vec3i::Constant(kFar - 1);
  return {low.cwiseMin(end), (high.cwiseMin(end) - low.cwiseMin(end)).cwiseMax(0)};
}

// How the particles of some cells have moved; each is asked once.
class Motions {
 public:
  Motions(const Organ& organ, const TissueModel& tissue, const IndexBox& cells)
      : organ_(organ),
        lattice_(organ.rest.lattice),
        tissue_(tissue),
        cells_(cells),
        perRow_(1.0 / lattice_.dims.x()),
        perPlane_(1.0 / lattice_.dims.y()),
        placeOf_(cells.count(), kUnknown),
        motionOf_(cells.count(), kUnknown) {}

  // visit(number in the box, lattice index) for the particles in cells low to high, both included.
  template <typename Visit>
  void visitParticles(const Vec3i& low, const Vec3i& high, Visit visit) const {
    for (int z = low.z(); z <= high.z(); ++z)
      for (int y = low.y(); y <= high.y(); ++y) {
        std::int64_t cell = lattice_.index({low.x(), y, z});
        std::int32_t i = cells_.index({low.x(), y, z});
        for (int x = low.x(); x <= high.x(); ++x, ++cell, ++i)
          if (organ_.alive[std::size_t(cell)] && organ_.rest.inside[std::size_t(cell)])
            visit(i, cell);
      }
  }

  const Vec3& place(std::int32_t i, std::int64_t cell) {
    std::int32_t& known = placeOf_[std::size_t(i)];
    if (known == kUnknown) {
      known = std::int32_t(places_.size());
      places_.push_back(lattice_.centre(cells_.place(i)) + tissue_.displacement(cell));
    }
    return places_[std::size_t(known)];
  }
  const ParticleMotion& of(std::int32_t i, std::int64_t cell) {
    std::int32_t& known = motionOf_[std::size_t(i)];
    if (known == kUnknown) {
      CellPlacement place;
      tissue_.place({&cell, 1}, {&place, 1});
      known = std::int32_t(motions_.size());
      const Vec3 rest = lattice_.centre(cells_.place(i));
      motions_.push_back({rest, rest + place.displacement.cast<double>(),
                          Mat3::Identity() + place.gradient.cast<double>()});
    }
    return motions_[std::size_t(known)];
  }
  const ParticleMotion& of(std::int64_t cell) {
    // Without dividing integers, which would cost more than all else: half a cell on, a quotient is
    // never so near a whole number that rounding matters.
    const int row = int((double(cell) + 0.5) * perRow_), z = int((row + 0.5) * perPlane_);
    const Vec3i at(int(cell - std::int64_t(row) * lattice_.dims.x()), row - z * lattice_.dims.y(),
                   z);
    return of(cells_.index(at), cell);
  }

 private:
  static constexpr std::int32_t kUnknown = -1;
  const Organ& organ_;
  const Lattice& lattice_;
  const TissueModel& tissue_;
  IndexBox cells_;
  double perRow_, perPlane_;
  std::vector<std::int32_t> placeOf_, motionOf_;
  std::vector<Vec3> places_;
  std::vector<ParticleMotion> motions_;
};

// Bounds of where the nodes of a brick are now. A node lies among the places that the particles of
// its lattice cube take it to; beside a cut some follow particles farther away.
class BrickPlaces {
 public:
  BrickPlaces(const Organ& organ, Motions& motions, const Vec3i& brick)
      : organ_(organ), motions_(motions), brick_(brick) {
    reach(organ.severed.near(organ.field.brickIndex(brick)) ? 1 : 0);
    if (rough_.empty()) reach(1);
  }

  // From the particles' places alone: however stretched, no node strays two spacings from them.
  Aabb rough() const { return widened(rough_, 2.0); }
  // From where each particle takes the whole brick.
  Aabb close() const {
    Aabb box;
    visitTaken([&](const Vec3& middle, const Mat3& half) {
      const Vec3 reach = half.cwiseAbs().rowwise().sum();
      box.grow(Aabb{middle - reach, middle + reach});
    });
    return widened(box, 0.25);
  }
  // The same of its eighths (number: 1 for the upper half along x, 2 along y, 4 along z).
  std::array<Aabb, 8> eighths() const {
    std::array<Aabb, 8> boxes;
    visitTaken([&](const Vec3& middle, const Mat3& half) {
      const Vec3 reach = 0.5 * half.cwiseAbs().rowwise().sum();
      for (unsigned e = 0; e < 8; ++e) {
        const Vec3 at = middle + (e & 1 ? 0.5 : -0.5) * half.col(0) +
                        (e & 2 ? 0.5 : -0.5) * half.col(1) + (e & 4 ? 0.5 : -0.5) * half.col(2);
        boxes[e].grow(Aabb{at - reach, at + reach});
      }
    });
    for (Aabb& box : boxes) box = widened(box, 0.25);
    return boxes;
  }

 private:
  // Particles at the corners of the cubes that hold the brick's nodes, and `more` beyond.
  void reach(int more) {
    const int refine = organ_.field.refine();
    const Vec3i end = kBrickNodes * (brick_ + Vec3i::Ones()) + Vec3i::Constant(refine - 1);
    // Cell c lies at node refine * (c + 2).
    low_ = (kBrickNodes * brick_ / refine - Vec3i::Constant(2 + more)).cwiseMax(0);
    high_ = (end / refine - Vec3i::Constant(2 - more))
                .cwiseMin(organ_.rest.lattice.dims - Vec3i::Ones());
    rough_ = {};
    motions_.visitParticles(low_, high_, [&](std::int32_t i, std::int64_t cell) {
      rough_.grow(motions_.place(i, cell));
    });
  }
  // visit(middle, half): where a particle takes the brick's middle, and its half sides as columns.
  template <typename Visit>
  void visitTaken(Visit visit) const {
    const ColourField& field = organ_.field;
    const Vec3 half = 0.5 * kBrickNodes * field.lattice().spacing / field.refine();
    const Vec3 middle = field.nodePosition((kBrickNodes * brick_).cast<double>()) + half;
    motions_.visitParticles(low_, high_, [&](std::int32_t i, std::int64_t cell) {
      const ParticleMotion& motion = motions_.of(i, cell);
      visit(Vec3(motion.position + motion.gradient * (middle - motion.rest)),
            Mat3(motion.gradient * half.asDiagonal()));
    });
  }
  Aabb widened(const Aabb& box, double spacings) const {
    const Vec3 slack = Vec3::Constant(spacings * organ_.rest.lattice.spacing.maxCoeff());
    return {box.min - slack, box.max + slack};
  }

  const Organ& organ_;
  Motions& motions_;
  Vec3i brick_;
  Vec3i low_, high_;  // cells
  Aabb rough_;        // of their particles
};

// The blade as boxes of its triangles.
struct BladeBoxes {
  Aabb all;
  std::vector<Aabb> triangles;

  explicit BladeBoxes(const SweptBlade& blade) : all(blade.bounds) {
    for (const BladeTriangle& t : blade.triangles) {
      Aabb& box = triangles.emplace_back();
      for (const Vec3& p : {t.corner, t.otherU, t.otherV}) box.grow(p);
    }
  }
  // Can the blade meet something in the box?
  bool mayMeet(const Aabb& box) const {
    return meets(all, box) &&
           std::ranges::any_of(triangles, [&](const Aabb& t) { return meets(t, box); });
  }
};

// The nodes of the eighths of a brick that the blade may meet: no other one's edges can be severed.
PlacedNodes nodesToPlace(const BladeBoxes& blade, const BrickPlaces& brick) {
  PlacedNodes nodes;
  if (!meets(blade.all, brick.rough()) || !blade.mayMeet(brick.close())) return nodes;
  const std::array<Aabb, 8> eighths = brick.eighths();
  constexpr int kHalf = kBrickNodes / 2;
  for (int e = 0; e < 8; ++e) {
    if (!blade.mayMeet(eighths[std::size_t(e)])) continue;
    const Vec3i first = kHalf * Vec3i(e & 1, e >> 1 & 1, e >> 2);
    for (int z = 0; z <= kHalf; ++z)
      for (int y = 0; y <= kHalf; ++y)
        for (int x = 0; x <= kHalf; ++x)
          nodes.set(std::size_t(((first.z() + z) * 5 + first.y() + y) * 5 + first.x() + x));
  }
  return nodes;
}

}  // namespace

std::int64_t inciseMoved(Organ& organ, const TissueModel& tissue, const SweptBlade& blade,
                         std::span<const std::int64_t> nearCells) {
  if (blade.empty() || nearCells.empty()) return 0;
  std::vector<std::int64_t> bricks = bricksRound(organ, nearCells);
  if (bricks.empty()) return 0;
  Motions motions(organ, tissue, cellsRound(organ, bricks));
  const BladeBoxes boxes(blade);
  std::vector<PlacedNodes> wanted;  // of the bricks that stay
  std::erase_if(bricks, [&](std::int64_t index) {
    const PlacedNodes nodes =
        nodesToPlace(boxes, BrickPlaces(organ, motions, organ.field.brick(index)));
    if (nodes.any()) wanted.push_back(nodes);
    return nodes.none();
  });
  const auto motionOf = [&](std::int64_t cell) -> const ParticleMotion& {
    return motions.of(cell);
  };
  const Wound wound{organ.severed, organ.alive};
  auto nodes = wanted.begin();
  return incise(
      organ, blade, bricks, [&](const Vec3i& brick, std::span<Vec3, kPlacedNodes> places) {
        placeNodes(organ.field, wound, organ.surface.iso(), brick, *nodes++, motionOf, places);
      });
}

}  // namespace resect
