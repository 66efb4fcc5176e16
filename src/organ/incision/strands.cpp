#include "organ/incision/strands.h"

#include <algorithm>
#include <array>
#include <bit>

#include "base/index_box.h"
#include "organ/incision/node_owners.h"
#include "tissue/stencil.h"

namespace resect {
namespace {

// The set of nodes of some lattice cubes, in ascending order.
class NodeSet {
 public:
  enum Which : std::uint8_t { kBesideCuts = 1, kAll = 2 };

  explicit NodeSet(const IndexBox& box) : box_(box), wanted_(box.count(), 0) {}

  // Adds the nodes of `side` grid cells along each axis from a node on: all, or those in bricks
  // near a cut.
  void add(const Vec3i& first, int side, unsigned which) {
    for (int z = 0; z <= side; ++z)
      for (int y = 0; y <= side; ++y) {
        std::uint8_t* row = wanted_.data() + box_.index(first + Vec3i(0, y, z));
        for (int x = 0; x <= side; ++x) row[x] |= std::uint8_t(which);
      }
  }
  // Lists those that lie in tissue. grid: for the box.
  void list(const Organ& organ, TissueGrid& grid) {
    number_.assign(wanted_.size(), -1);
    const Vec3i end = box_.low + box_.dims;
    std::size_t i = 0;
    for (int z = box_.low.z(); z < end.z(); ++z)
      for (int y = box_.low.y(); y < end.y(); ++y)
        for (int x = box_.low.x(); x < end.x(); ++x, ++i) {
          if (wanted_[i] == 0) continue;
          const Vec3i node(x, y, z);
          if (!grid.inTissue(node)) continue;
          if (wanted_[i] == kBesideCuts &&
              !organ.severed.near(organ.field.brickIndex(node / kBrickNodes)))
            continue;
          number_[i] = std::int32_t(nodes_.size());
          nodes_.push_back(node);
        }
  }

  const std::vector<Vec3i>& all() const { return nodes_; }
  std::int32_t find(const Vec3i& node) const {  // -1 when it is not listed
    return box_.contains(node) ? number_[std::size_t(box_.index(node))] : -1;
  }

 private:
  IndexBox box_;
  std::vector<std::uint8_t> wanted_;  // per node of the box
  std::vector<std::int32_t> number_;
  std::vector<Vec3i> nodes_;
};

// A particle that has lost bonds to other remaining particles.
struct Parting {
  Vec3i cell;
  std::uint32_t lost;  // by direction
  NodeSet::Which which;
};

// Lattice cubes, by the cell at their lowest corner, whose nodes may have owners that are not
// bonded. In a cube whose edges are all whole a node's owner is one of the corners; if none of the
// bonds between corners is lost, no edge needs severing.
class PartingCubes {
 public:
  explicit PartingCubes(std::span<const Parting> partings) {  // at least one
    std::vector<Vec3i> cells;
    for (const Parting& p : partings)
      for (const int step : {-1, 0}) cells.push_back(p.cell + Vec3i::Constant(step));
    box_ = boxRound(cells);
    marks_.assign(box_.count(), 0);
    for (const Parting& p : partings)
      for (int o = 0; o < 8; ++o) {
        const Vec3i up(o & 1, o >> 1 & 1, o >> 2);  // on which sides of the cell the cube lies
        marks_[std::size_t(box_.index(p.cell - Vec3i::Ones() + up))] |=
            p.which | (p.lost & within(up) ? kLost : 0);
      }
  }
  IndexBox nodes(int refine) const {
    return {refine * (box_.low + Vec3i::Constant(2)), refine * box_.dims + Vec3i::Ones()};
  }
  void addNodes(const Organ& organ, TissueGrid& grid, NodeSet& nodes) const {
    const int refine = organ.field.refine();
    for (std::size_t i = 0; i < marks_.size(); ++i) {
      if (marks_[i] == 0) continue;
      const Vec3i cube = box_.coordinates(std::int32_t(i)),
                  first = refine * (cube + Vec3i::Constant(2));
      if (marks_[i] & kLost || !full(organ, cube) || !grid.whole(first, refine))
        nodes.add(first, refine, marks_[i] & (NodeSet::kBesideCuts | NodeSet::kAll));
    }
  }

 private:
  static constexpr std::uint8_t kLost = 4;  // beside NodeSet::Which

  // The directions from one corner of a cube to its other corners.
  static std::uint32_t within(const Vec3i& up) {
    std::uint32_t directions = 0;
    for (int c = 1; c < 8; ++c) {
      const Vec3i step(c & 1, c >> 1 & 1, c >> 2);
      directions |= 1u << directionTo(step.cwiseProduct(2 * up - Vec3i::Ones()));
    }
    return directions;
  }
  static bool full(const Organ& organ, const Vec3i& cube) {
    for (int c = 0; c < 8; ++c) {
      const Vec3i cell = cube + Vec3i(c & 1, c >> 1 & 1, c >> 2);
      if (!organ.rest.lattice.contains(cell)) return false;
      const std::size_t i = std::size_t(organ.rest.lattice.index(cell));
      if (!organ.alive[i] || !organ.rest.inside[i]) return false;
    }
    return true;
  }

  IndexBox box_;
  std::vector<std::uint8_t> marks_;
};

// Whether two particles are bonded, or both to a third one; with a cache, since pairs repeat.
class Holds {
 public:
  Holds(const Lattice& lattice, const TissueModel& tissue) : lattice_(lattice), tissue_(tissue) {}

  bool operator()(std::int64_t p, std::int64_t q) {
    Answer& known = known_[std::size_t((p * 5 + q) % kAnswers)];
    if (known.p != p || known.q != q) known = {p, q, held(p, q)};
    return known.held;
  }

 private:
  static constexpr std::int64_t kAnswers = 64;
  struct Answer {
    std::int64_t p = -1, q = -1;
    bool held = false;
  };
  bool held(std::int64_t p, std::int64_t q) const {
    const Vec3i from = lattice_.cell(p), to = lattice_.cell(q);
    const auto bonded = [&](std::int64_t particle, const Vec3i& cell) {
      const Vec3i offset = to - cell;
      if (offset.cwiseAbs().maxCoeff() > 1) return false;
      return offset == Vec3i::Zero() || (tissue_.bonds(particle) >> directionTo(offset) & 1) != 0;
    };
    if (bonded(p, from)) return true;
    for (std::uint32_t bonds = tissue_.bonds(p); bonds != 0; bonds &= bonds - 1) {
      const Vec3i third = from + offsetOf(std::countr_zero(bonds));
      if (bonded(lattice_.index(third), third)) return true;
    }
    return false;
  }
  const Lattice& lattice_;
  const TissueModel& tissue_;
  std::array<Answer, kAnswers> known_;
};

}  // namespace

std::int64_t partStrands(Organ& organ, const TissueModel& tissue,
                         std::span<const TissueBond> parted, std::span<const std::int64_t> near) {
  if (parted.empty() && (near.empty() || organ.severed.pending().empty())) return 0;
  const Lattice& lattice = organ.rest.lattice;
  const int refine = organ.field.refine();
  std::vector<Vec3i> changed;  // bricks
  for (const std::int64_t brick : organ.severed.pending())
    changed.push_back(organ.field.brick(brick));
  // Whether edges severed since the last update can have changed the owner of a node near this
  // particle.
  const auto concerned = [&](std::int64_t particle) {
    const Vec3i centre = refine * (lattice.cell(particle) + Vec3i::Constant(2));
    const int reach = NodeOwners::kFar + 1 + refine;
    for (const Vec3i& brick : changed) {
      const Vec3i low = kBrickNodes * brick, high = low + Vec3i::Constant(kBrickNodes);
      if (((centre - high).array() <= reach).all() && ((low - centre).array() <= reach).all())
        return true;
    }
    return false;
  };
  std::vector<Parting> partings;
  const auto addParting = [&](std::int64_t particle, NodeSet::Which which) {
    Parting parting{lattice.cell(particle), 0, which};
    for (std::uint32_t gone = kAllBonds & ~tissue.bonds(particle); gone != 0; gone &= gone - 1) {
      const int d = std::countr_zero(gone);
      const Vec3i to = parting.cell + offsetOf(d);
      if (lattice.contains(to) && tissue.solid(lattice.index(to))) parting.lost |= 1u << d;
    }
    if (parting.lost != 0) partings.push_back(parting);
  };
  for (const std::int64_t particle : near)
    if (concerned(particle)) addParting(particle, NodeSet::kBesideCuts);
  for (const TissueBond& bond : parted) {
    addParting(bond.cell, NodeSet::kAll);
    addParting(lattice.index(lattice.cell(bond.cell) + offsetOf(bond.direction)), NodeSet::kAll);
  }
  if (partings.empty()) return 0;
  const PartingCubes cubes(partings);
  const IndexBox box = cubes.nodes(refine);
  TissueGrid grid(organ, box.widened(NodeOwners::kFar));
  NodeSet nodes(box);
  cubes.addNodes(organ, grid, nodes);
  nodes.list(organ, grid);
  NodeOwners ownerOf(organ, grid, box);
  std::vector<std::int64_t> owners;
  for (const Vec3i& n : nodes.all()) owners.push_back(ownerOf(n));

  Holds held(lattice, tissue);
  std::vector<std::pair<Vec3i, int>> strands;
  for (std::size_t k = 0; k < owners.size(); ++k) {
    const Vec3i& node = nodes.all()[k];
    const unsigned ways = grid.ways(node);
    for (int axis = 0; axis < 3; ++axis) {
      if (!(ways >> (2 * axis + 1) & 1)) continue;
      const std::int32_t to = nodes.find(node + Vec3i::Unit(axis));
      if (to < 0) continue;
      const std::int64_t p = owners[k], q = owners[std::size_t(to)];
      if (p >= 0 && q >= 0 && p != q && !held(p, q)) strands.push_back({node, axis});
    }
  }
  for (const auto& [node, axis] : strands) organ.severed.sever(node, axis, 0.5, Vec3::Unit(axis));
  return std::int64_t(strands.size());
}

}  // namespace resect
