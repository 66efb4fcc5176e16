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

// The particle that a node of the grid goes with: the one fewest whole edges away through tissue;
// of several the first. -1 when none is within kFar.
class NodeOwners {
 public:
  explicit NodeOwners(const Organ& organ) : organ_(organ), dims_(organ.field.nodeDims()) {}

  bool tissue(const Vec3i& node) const {
    return (node.array() >= 0).all() && (node.array() < dims_.array()).all() &&
           organ_.field.node(node) >= organ_.surface.iso();
  }

  static constexpr int kFar = 6;  // edges

  std::int64_t operator()(const Vec3i& node) {
    seen_.assign(1, node);
    std::int64_t owner = -1;
    std::size_t layer = 0;
    for (int steps = 0; steps <= kFar && layer < seen_.size(); ++steps) {
      const std::size_t end = seen_.size();
      for (std::size_t k = layer; k < end; ++k) {
        const std::int64_t particle = particleAt(seen_[k]);
        if (particle >= 0 && (owner < 0 || particle < owner)) owner = particle;
      }
      if (owner >= 0) return owner;
      for (std::size_t k = layer; k < end; ++k)
        for (int axis = 0; axis < 3; ++axis)
          for (const int side : {-1, 1}) {
            const Vec3i from = seen_[k], to = from + side * Vec3i::Unit(axis);
            if (!tissue(to) || organ_.severed.at(side < 0 ? to : from, axis) != kWhole) continue;
            if (std::find(seen_.begin(), seen_.end(), to) == seen_.end()) seen_.push_back(to);
          }
      layer = end;
    }
    return owner;
  }

 private:
  std::int64_t particleAt(const Vec3i& node) const {
    const int refine = organ_.field.refine();
    const Vec3i cell = node / refine - Vec3i::Constant(2);
    if ((node.array() != (refine * (cell.array() + 2))).any()) return -1;
    if (!organ_.rest.lattice.contains(cell)) return -1;
    const std::int64_t index = organ_.rest.lattice.index(cell);
    return organ_.alive[index] && organ_.rest.inside[index] ? index : -1;
  }

  const Organ& organ_;
  Vec3i dims_;
  std::vector<Vec3i> seen_;
};

// Are two particles bonded, or both to a third one?
bool held(const Lattice& lattice, const TissueModel& tissue, std::int64_t p, std::int64_t q) {
  const Vec3i from = lattice.cell(p), to = lattice.cell(q);
  const auto bonded = [&](const Vec3i& a, const Vec3i& b) {
    for (int d = 0; d < kDirections; ++d)
      if (a + offsetOf(d) == b) return (tissue.bonds(lattice.index(a)) >> d & 1) != 0;
    return false;
  };
  if (bonded(from, to)) return true;
  for (int d = 0; d < kDirections; ++d)
    if (tissue.bonds(p) >> d & 1 && bonded(from + offsetOf(d), to)) return true;
  return false;
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

std::int64_t partStrands(Organ& organ, const TissueModel& tissue,
                         std::span<const TissueBond> parted, std::span<const std::int64_t> near) {
  if (parted.empty() && (near.empty() || organ.severed.pending().empty())) return 0;
  const Lattice& lattice = organ.rest.lattice;
  const int refine = organ.field.refine();
  NodeOwners ownerOf(organ);
  std::vector<Vec3i> changed;  // bricks
  for (const std::int64_t brick : organ.severed.pending())
    changed.push_back(organ.field.brick(brick));
  // Can what was severed since the last picture have changed the owner of a node round here?
  const auto concerned = [&](std::int64_t particle) {
    const Vec3i centre = refine * (lattice.cell(particle) + Vec3i::Constant(2));
    const int reach = NodeOwners::kFar + 1 + refine;
    return std::ranges::any_of(changed, [&](const Vec3i& brick) {
      const Vec3i low = kBrickNodes * brick, high = low + Vec3i::Constant(kBrickNodes);
      return ((centre - high).array() <= reach).all() && ((low - centre).array() <= reach).all();
    });
  };
  std::vector<Vec3i> nodes;
  const auto addNodes = [&](std::int64_t particle, bool cutOnly) {
    const Vec3i centre = refine * (lattice.cell(particle) + Vec3i::Constant(2));
    for (int z = -refine; z <= refine; ++z)
      for (int y = -refine; y <= refine; ++y)
        for (int x = -refine; x <= refine; ++x) {
          const Vec3i n = centre + Vec3i(x, y, z);
          if (!ownerOf.tissue(n)) continue;
          if (!cutOnly || organ.severed.near(organ.field.brickIndex(n / kBrickNodes)))
            nodes.push_back(n);
        }
  };
  for (const std::int64_t particle : near)
    if (concerned(particle)) addNodes(particle, true);
  for (const TissueBond& bond : parted) {
    addNodes(bond.cell, false);
    addNodes(lattice.index(lattice.cell(bond.cell) + offsetOf(bond.direction)), false);
  }
  const auto before = [](const Vec3i& a, const Vec3i& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  };
  std::sort(nodes.begin(), nodes.end(), before);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  std::vector<std::int64_t> owners;
  for (const Vec3i& n : nodes) owners.push_back(ownerOf(n));

  std::vector<std::pair<Vec3i, int>> strands;
  for (std::size_t k = 0; k < nodes.size(); ++k)
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3i to = nodes[k] + Vec3i::Unit(axis);
      const auto found = std::lower_bound(nodes.begin(), nodes.end(), to, before);
      if (found == nodes.end() || *found != to) continue;
      if (organ.severed.at(nodes[k], axis) != kWhole) continue;
      const std::int64_t p = owners[k], q = owners[std::size_t(found - nodes.begin())];
      if (p >= 0 && q >= 0 && p != q && !held(lattice, tissue, p, q))
        strands.push_back({nodes[k], axis});
    }
  for (const auto& [node, axis] : strands) organ.severed.sever(node, axis, 0.5, Vec3::Unit(axis));
  return std::int64_t(strands.size());
}

}  // namespace resect
