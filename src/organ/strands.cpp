#include "organ/strands.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include "base/index_box.h"
#include "surface/brick_mesher.h"
#include "tissue/stencil.h"

namespace resect {
namespace {

// Which nodes of a box lie in tissue, and which whole edges lead from one to the next? Found brick
// by brick, 64 nodes at a time, where asked.
class TissueGrid {
 public:
  // Bit 2 axis + up of ways().
  static constexpr unsigned kAllWays = 0x3f;

  // For the nodes of the box and those beside it, which may lie outside the field.
  TissueGrid(const Organ& organ, const IndexBox& nodes) : organ_(organ) {
    const Vec3i low = brickOf(nodes.low - Vec3i::Ones());
    const Vec3i high = brickOf(nodes.low + nodes.dims);
    box_ = {low,
            high - low + Vec3i::Constant(2)};  // and the brick above, for edges that lead there
    bricks_.resize(box_.count());
  }

  bool inTissue(const Vec3i& node) { return inside(brickOf(node)) >> bitOf(node) & 1; }
  // The whole edges from a node in tissue to others in tissue.
  unsigned ways(const Vec3i& node) {
    const Brick& own = brick(brickOf(node));
    const int bit = bitOf(node);
    unsigned found = 0;
    for (int axis = 0; axis < 3; ++axis) {
      found |= unsigned(own.whole[axis] >> bit & 1) << (2 * axis + 1);
      const Vec3i below = node - Vec3i::Unit(axis);
      const Brick& lower = (node[axis] & 3) != 0 ? own : brick(brickOf(below));
      found |= unsigned(lower.whole[axis] >> bitOf(below) & 1) << (2 * axis);
    }
    return found;
  }

 private:
  struct Brick {
    bool insideKnown = false, wholeKnown = false;
    std::uint64_t inside = 0, whole[3] = {};  // whole: per axis, bit = lower node
  };

  static Vec3i brickOf(const Vec3i& n) { return {n.x() >> 2, n.y() >> 2, n.z() >> 2}; }
  static int bitOf(const Vec3i& n) { return (n.x() & 3) | (n.y() & 3) << 2 | (n.z() & 3) << 4; }

  std::uint64_t inside(const Vec3i& b) {
    Brick& made = bricks_[std::size_t(box_.index(b))];
    if (made.insideKnown) return made.inside;
    made.insideKnown = true;
    const ColourField& field = organ_.field;
    if ((b.array() >= 0).all() && (b.array() < field.brickDims().array()).all()) {
      const std::int32_t slot = field.slot(field.brickIndex(b));
      if (slot >= 0) made.inside = insideMask(field.values(slot), organ_.surface.iso());
      if (slot == ColourField::kFull) made.inside = ~std::uint64_t(0);
    }
    return made.inside;
  }
  const Brick& brick(const Vec3i& b) {
    Brick& made = bricks_[std::size_t(box_.index(b))];
    if (made.wholeKnown) return made;
    made.wholeKnown = true;
    if (inside(b) == 0) return made;
    std::array<std::uint64_t, 8> around{};  // the bricks above along one axis suffice
    around[0] = made.inside;
    for (int axis = 0; axis < 3; ++axis) around[1u << axis] = inside(b + Vec3i::Unit(axis));
    const auto corners = cornerMasks(around);
    for (int axis = 0; axis < 3; ++axis)
      made.whole[axis] = made.inside & corners[1u << axis] &
                         ~organ_.severed.mask(organ_.field.brickIndex(b), axis);
    return made;
  }

  const Organ& organ_;
  IndexBox box_;
  std::vector<Brick> bricks_;
};

// The particle that a node of the grid goes with: the one fewest whole edges away through tissue;
// of several the first. -1 when none is within kFar.
class NodeOwners {
 public:
  static constexpr int kFar = 6;  // edges

  // For the nodes of the box. Cost: a byte per node of the box and of kFar round it, and
  // four for each number of edges that some node's owner is away.
  NodeOwners(const Organ& organ, const IndexBox& box)
      : organ_(organ),
        box_{box.low - Vec3i::Constant(kFar), box.dims + Vec3i::Constant(2 * kFar)},
        grid_(organ, box_),
        ways_(box_.count(), 0) {}

  // node: in tissue.
  std::int64_t operator()(const Vec3i& node) {
    const std::int32_t i = box_.index(node);
    for (int edges = 0; edges <= kFar; ++edges)
      if (const std::int32_t owner = firstWithin(edges, i); owner != kNobody) return owner;
    return -1;
  }

 private:
  static constexpr std::uint8_t kKnown = 0x80;  // beside the ways
  static constexpr std::int32_t kNobody = std::numeric_limits<std::int32_t>::max(), kUnknown = -1;

  // The first of all particles within so many edges of a node: of its neighbours' and its own
  // within one edge less, each asked once.
  std::int32_t firstWithin(int edges, std::int32_t i) {
    std::vector<std::int32_t>& known = firstWithin_[std::size_t(edges)];
    if (known.empty()) known.assign(box_.count(), kUnknown);
    if (known[std::size_t(i)] != kUnknown) return known[std::size_t(i)];
    std::int32_t first = kNobody;
    if (edges == 0) {
      if (const std::int64_t p = particleAt(box_.place(i)); p >= 0) first = std::int32_t(p);
    } else {
      first = firstWithin(edges - 1, i);
      for (unsigned ways = waysFrom(i) & TissueGrid::kAllWays; ways != 0; ways &= ways - 1) {
        const int way = std::countr_zero(ways), step = box_.step(way / 2);
        first = std::min(first, firstWithin(edges - 1, way % 2 ? i + step : i - step));
      }
    }
    return known[std::size_t(i)] = first;
  }

  unsigned waysFrom(std::int32_t i) {
    std::uint8_t& ways = ways_[std::size_t(i)];
    if (ways == 0) ways = std::uint8_t(kKnown | grid_.ways(box_.place(i)));
    return ways;
  }

  std::int64_t particleAt(const Vec3i& node) const {
    const int refine = organ_.field.refine();
    const Vec3i cell = node / refine - Vec3i::Constant(2);
    if ((node.array() != (refine * (cell.array() + 2))).any()) return -1;
    if (!organ_.rest.lattice.contains(cell)) return -1;
    const std::int64_t index = organ_.rest.lattice.index(cell);
    return organ_.alive[index] && organ_.rest.inside[index] ? index : -1;
  }

  const Organ& organ_;
  IndexBox box_;
  TissueGrid grid_;
  std::vector<std::uint8_t> ways_;  // per node; 0: not looked at
  std::array<std::vector<std::int32_t>, kFar + 1> firstWithin_;
};

// The nodes round some particles, each once, in ascending order.
class NodeSet {
 public:
  enum Which : std::uint8_t { kNone, kBesideCuts, kAll };
  explicit NodeSet(int reach) : reach_(reach) {}

  void add(const Vec3i& centre, Which which) { centres_.push_back({centre, which}); }

  // Lists those that lie in tissue, of kBesideCuts those in bricks near a cut. Cost: a byte per
  // node of the box round all.
  void list(const Organ& organ) {
    if (centres_.empty()) return;
    Vec3i low = centres_[0].first, high = low;
    for (const auto& [centre, which] : centres_) {
      low = low.cwiseMin(centre);
      high = high.cwiseMax(centre);
    }
    box_ = {low - Vec3i::Constant(reach_), high - low + Vec3i::Constant(2 * reach_ + 1)};
    std::vector<std::uint8_t> wanted(box_.count(), kNone);
    for (const auto& [centre, which] : centres_)
      for (int z = -reach_; z <= reach_; ++z)
        for (int y = -reach_; y <= reach_; ++y) {
          std::uint8_t* row = wanted.data() + box_.index(centre + Vec3i(-reach_, y, z));
          for (int x = 0; x <= 2 * reach_; ++x) row[x] = std::max(row[x], std::uint8_t(which));
        }
    number_.assign(wanted.size(), -1);
    TissueGrid grid(organ, box_);
    const Vec3i end = box_.low + box_.dims;
    std::size_t i = 0;
    for (int z = box_.low.z(); z < end.z(); ++z)
      for (int y = box_.low.y(); y < end.y(); ++y)
        for (int x = box_.low.x(); x < end.x(); ++x, ++i) {
          if (wanted[i] == kNone) continue;
          const Vec3i node(x, y, z);
          if (!grid.inTissue(node)) continue;
          if (wanted[i] == kBesideCuts &&
              !organ.severed.near(organ.field.brickIndex(node / kBrickNodes)))
            continue;
          number_[i] = std::int32_t(nodes_.size());
          nodes_.push_back(node);
        }
  }

  const IndexBox& box() const { return box_; }
  const std::vector<Vec3i>& all() const { return nodes_; }
  std::int32_t find(const Vec3i& node) const {  // -1 when it is not listed
    return box_.contains(node) ? number_[std::size_t(box_.index(node))] : -1;
  }

 private:
  int reach_;
  std::vector<std::pair<Vec3i, Which>> centres_;
  IndexBox box_;
  std::vector<std::int32_t> number_;
  std::vector<Vec3i> nodes_;
};

// Are two particles bonded, or both to a third one?
bool held(const Lattice& lattice, const TissueModel& tissue, std::int64_t p, std::int64_t q) {
  const Vec3i to = lattice.cell(q);
  const auto bonded = [&](std::int64_t from, const Vec3i& cell) {
    const Vec3i offset = to - cell;
    if (offset.cwiseAbs().maxCoeff() > 1) return false;
    return offset == Vec3i::Zero() || (tissue.bonds(from) >> directionTo(offset) & 1) != 0;
  };
  const Vec3i from = lattice.cell(p);
  if (bonded(p, from)) return true;
  for (std::uint32_t bonds = tissue.bonds(p); bonds != 0; bonds &= bonds - 1) {
    const Vec3i third = from + offsetOf(std::countr_zero(bonds));
    if (bonded(lattice.index(third), third)) return true;
  }
  return false;
}

}  // namespace

std::int64_t partStrands(Organ& organ, const TissueModel& tissue,
                         std::span<const TissueBond> parted, std::span<const std::int64_t> near) {
  if (parted.empty() && (near.empty() || organ.severed.pending().empty())) return 0;
  const Lattice& lattice = organ.rest.lattice;
  const int refine = organ.field.refine();
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
  NodeSet nodes(refine);
  const auto centreOf = [&](std::int64_t particle) {
    return Vec3i(refine * (lattice.cell(particle) + Vec3i::Constant(2)));
  };
  for (const std::int64_t particle : near)
    if (concerned(particle)) nodes.add(centreOf(particle), NodeSet::kBesideCuts);
  for (const TissueBond& bond : parted) {
    nodes.add(centreOf(bond.cell), NodeSet::kAll);
    nodes.add(centreOf(lattice.index(lattice.cell(bond.cell) + offsetOf(bond.direction))),
              NodeSet::kAll);
  }
  nodes.list(organ);
  NodeOwners ownerOf(organ, nodes.box());
  std::vector<std::int64_t> owners;
  for (const Vec3i& n : nodes.all()) owners.push_back(ownerOf(n));

  std::vector<std::pair<Vec3i, int>> strands;
  for (std::size_t k = 0; k < owners.size(); ++k)
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3i node = nodes.all()[k];
      const std::int32_t to = nodes.find(node + Vec3i::Unit(axis));
      if (to < 0 || organ.severed.at(node, axis) != kWhole) continue;
      const std::int64_t p = owners[k], q = owners[std::size_t(to)];
      if (p >= 0 && q >= 0 && p != q && !held(lattice, tissue, p, q))
        strands.push_back({node, axis});
    }
  for (const auto& [node, axis] : strands) organ.severed.sever(node, axis, 0.5, Vec3::Unit(axis));
  return std::int64_t(strands.size());
}

}  // namespace resect
