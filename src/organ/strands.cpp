#include "organ/strands.h"

#include <algorithm>
#include <limits>

#include "tissue/stencil.h"

namespace resect {
namespace {

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

// The nodes round some particles, each once, in ascending order of x, y, z.
class NodeSet {
 public:
  enum Which : std::uint8_t { kNone, kBesideCuts, kAll };
  explicit NodeSet(int reach) : reach_(reach) {}

  void add(const Vec3i& centre, Which which) { centres_.push_back({centre, which}); }

  // Lists those that `take(node, which)` is true for. Cost: a byte per node of the box round all.
  template <typename Take>
  void list(const Take& take) {
    const Vec3i reach = Vec3i::Constant(reach_);
    low_ = Vec3i::Constant(std::numeric_limits<int>::max());
    Vec3i high = Vec3i::Constant(std::numeric_limits<int>::min());
    for (const auto& [centre, which] : centres_) {
      low_ = low_.cwiseMin(centre - reach);
      high = high.cwiseMax(centre + reach);
    }
    if (centres_.empty()) return;
    dims_ = high - low_ + Vec3i::Ones();
    std::vector<std::uint8_t> wanted(std::size_t(dims_.cast<std::int64_t>().prod()), kNone);
    for (const auto& [centre, which] : centres_)
      for (int x = -reach_; x <= reach_; ++x)
        for (int y = -reach_; y <= reach_; ++y)
          for (int z = -reach_; z <= reach_; ++z) {
            std::uint8_t& mark = wanted[index(centre + Vec3i(x, y, z))];
            mark = std::max(mark, std::uint8_t(which));
          }
    number_.assign(wanted.size(), -1);
    Vec3i n;
    for (n.x() = low_.x(); n.x() <= high.x(); ++n.x())
      for (n.y() = low_.y(); n.y() <= high.y(); ++n.y())
        for (n.z() = low_.z(); n.z() <= high.z(); ++n.z()) {
          const auto which = Which(wanted[index(n)]);
          if (which == kNone || !take(n, which)) continue;
          number_[index(n)] = std::int32_t(nodes_.size());
          nodes_.push_back(n);
        }
  }

  const std::vector<Vec3i>& all() const { return nodes_; }
  std::int32_t find(const Vec3i& node) const {  // -1 when it is not listed
    const Vec3i at = node - low_;
    return (at.array() >= 0).all() && (at.array() < dims_.array()).all() ? number_[index(node)]
                                                                         : -1;
  }

 private:
  std::size_t index(const Vec3i& n) const {
    const Vec3i at = n - low_;
    return (std::size_t(at.x()) * std::size_t(dims_.y()) + std::size_t(at.y())) *
               std::size_t(dims_.z()) +
           std::size_t(at.z());
  }

  int reach_;
  std::vector<std::pair<Vec3i, Which>> centres_;
  Vec3i low_ = Vec3i::Zero(), dims_ = Vec3i::Zero();
  std::vector<std::int32_t> number_;
  std::vector<Vec3i> nodes_;
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
    return ownerOf.tissue(n) &&
           (which == NodeSet::kAll || organ.severed.near(organ.field.brickIndex(n / kBrickNodes)));
  });
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
