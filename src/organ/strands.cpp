#include "organ/strands.h"

#include <algorithm>
#include <bit>

#include "base/index_box.h"
#include "tissue/stencil.h"

namespace resect {
namespace {

bool inTissue(const Organ& organ, const Vec3i& node) {
  return (node.array() >= 0).all() && (node.array() < organ.field.nodeDims().array()).all() &&
         organ.field.node(node) >= organ.surface.iso();
}

// The particle that a node of the grid goes with: the one fewest whole edges away through tissue;
// of several the first. -1 when none is within kFar.
class NodeOwners {
 public:
  static constexpr int kFar = 6;  // edges

  // For the nodes of the box. Cost: five bytes per node of the box and of kFar round it.
  NodeOwners(const Organ& organ, const IndexBox& box)
      : organ_(organ),
        box_{box.low - Vec3i::Constant(kFar), box.dims + Vec3i::Constant(2 * kFar)},
        ways_(box_.count(), 0),
        seenIn_(box_.count(), 0) {}

  std::int64_t operator()(const Vec3i& node) {
    ++search_;
    queue_.clear();
    enqueue(box_.index(node));
    std::int64_t owner = -1;
    for (std::size_t layer = 0, steps = 0; layer < queue_.size(); ++steps) {
      const std::size_t end = queue_.size();
      for (std::size_t k = layer; k < end; ++k)
        if (waysFrom(queue_[k]) & kParticle) {
          const std::int64_t particle = particleAt(box_.place(queue_[k]));
          if (owner < 0 || particle < owner) owner = particle;
        }
      if (owner >= 0 || steps == kFar) break;
      for (; layer < end; ++layer) {
        const std::int32_t from = queue_[layer];
        for (unsigned ways = waysFrom(from) & kAllWays; ways != 0; ways &= ways - 1) {
          const int way = std::countr_zero(ways), step = box_.step(way / 2);
          const std::int32_t to = way % 2 ? from + step : from - step;
          if (seenIn_[std::size_t(to)] != search_) enqueue(to);
        }
      }
    }
    return owner;
  }

 private:
  // Bit 2 axis + up: a whole edge leads to a node in tissue.
  static constexpr unsigned kAllWays = 0x3f, kParticle = 0x40, kKnown = 0x80;

  void enqueue(std::int32_t i) {
    seenIn_[std::size_t(i)] = search_;
    queue_.push_back(i);
  }

  unsigned waysFrom(std::int32_t i) {
    std::uint8_t& ways = ways_[std::size_t(i)];
    if (ways != 0) return ways;
    const Vec3i node = box_.place(i);
    unsigned found = kKnown;
    if (particleAt(node) >= 0) found |= kParticle;
    for (int way = 0; way < 6; ++way) {
      const Vec3i to = node + (way % 2 ? 1 : -1) * Vec3i::Unit(way / 2);
      if (inTissue(organ_, to) && organ_.severed.at(way % 2 ? node : to, way / 2) == kWhole)
        found |= 1u << way;
    }
    ways = std::uint8_t(found);
    return found;
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
  std::vector<std::uint8_t> ways_;  // per node; 0: not looked at
  std::uint32_t search_ = 0;
  std::vector<std::uint32_t> seenIn_;  // per node: the last search that saw it
  std::vector<std::int32_t> queue_;
};

// The nodes round some particles, each once, in ascending order.
class NodeSet {
 public:
  enum Which : std::uint8_t { kNone, kBesideCuts, kAll };
  explicit NodeSet(int reach) : reach_(reach) {}

  void add(const Vec3i& centre, Which which) { centres_.push_back({centre, which}); }

  // Lists those that `take(node, which)` is true for. Cost: a byte per node of the box round all.
  template <typename Take>
  void list(const Take& take) {
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
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (wanted[i] == kNone) continue;
      const Vec3i node = box_.place(std::int32_t(i));
      if (!take(node, Which(wanted[i]))) continue;
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
  nodes.list([&](const Vec3i& n, NodeSet::Which which) {
    return inTissue(organ, n) &&
           (which == NodeSet::kAll || organ.severed.near(organ.field.brickIndex(n / kBrickNodes)));
  });
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
