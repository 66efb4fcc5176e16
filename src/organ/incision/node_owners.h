// Owners of the colour field's grid nodes near cuts: for each node, the particle that the node
// belongs to.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/index_box.h"
#include "organ/organ.h"

namespace resect {

// Tells which nodes of a box lie in tissue, and which grid edges between such nodes are whole. A
// node lies in tissue if the colour field there is at least the iso level. A grid edge connects two
// neighbouring nodes. It is whole if no cut has severed it. The answers are computed when they are
// first asked for, for a whole brick of 64 nodes at once.
class TissueGrid {
 public:
  // nodes: the box. Nodes in the box, and nodes next to the box, may be asked for. A node outside
  // the colour field's grid is not in tissue.
  TissueGrid(const Organ& organ, const IndexBox& nodes);

  bool inTissue(const Vec3i& node) { return inside(brickOf(node)) >> bitOf(node) & 1; }
  // For a node in tissue: which of its six edges are whole and lead to a neighbouring node in
  // tissue. Bit 2 * axis stands for the edge downwards along the axis, bit 2 * axis + 1 for the
  // edge upwards.
  unsigned ways(const Vec3i& node);
  // Whether all nodes lie in tissue and all edges are whole in a block of grid cells. The block has
  // `side` cells along each axis; `first` is its lowest node.
  bool whole(const Vec3i& first, int side);

 private:
  struct Brick {
    bool insideKnown = false, wholeKnown = false, cellsKnown = false;
    // Bits stand for nodes. inside: nodes in tissue. whole: per axis, the lower nodes of whole
    // edges. cells: the lowest nodes of grid cells whose twelve edges are all whole.
    std::uint64_t inside = 0, whole[3] = {}, cells = 0;
  };

  static Vec3i brickOf(const Vec3i& n) { return {n.x() >> 2, n.y() >> 2, n.z() >> 2}; }
  static int bitOf(const Vec3i& n) { return (n.x() & 3) | (n.y() & 3) << 2 | (n.z() & 3) << 4; }

  std::uint64_t inside(const Vec3i& b);
  const Brick& brick(const Vec3i& b);
  std::uint64_t wholeCells(const Vec3i& b);

  const Organ& organ_;
  IndexBox box_;
  std::vector<Brick> bricks_;
};

// Finds the owner of a grid node. The centre of each particle is a grid node, too. The owner is the
// particle whose centre is reached from the node over the fewest edges; all these edges must be
// whole. If several particles are equally near, the particle with the lowest index is the
// owner. If no particle is within kFar edges, the result is -1.
class NodeOwners {
 public:
  static constexpr int kFar = 6;  // greatest distance of an owner, edges

  // box: the nodes whose owners can be asked for. grid: must cover the box and kFar further nodes
  // on each side. Memory: four bytes per node that the grid must cover, and eight per node of
  // `box`. Cost: proportional to the number of nodes that searches visit.
  NodeOwners(const Organ& organ, TissueGrid& grid, const IndexBox& box);

  // node: must lie in tissue.
  std::int64_t operator()(const Vec3i& node) {
    const std::int32_t owner = within(kFar, box_.index(node));
    return owner == kNobody ? -1 : owner;
  }

 private:
  static constexpr std::int32_t kNobody = std::numeric_limits<std::int32_t>::max(), kUnknown = -1;

  struct Known {
    std::int32_t owner = kNobody;
    // Radius searched so far, edges. If the owner has been found, this is the owner's distance. If
    // not, the owner is farther away.
    std::int8_t searched = 0;
    std::uint8_t ways;  // TissueGrid::ways() of the node
  };
  Known& known(std::int32_t i) {
    std::int32_t& number = number_[std::size_t(i)];
    if (number == kUnknown) number = lookAt(i);
    return known_[std::size_t(number)];
  }
  std::int32_t lookAt(std::int32_t i);

  // The owner of node i if that particle is at most `edges` away, else kNobody. The result is
  // selected without a branch, since the processor could not predict such a branch.
  std::int32_t within(int edges, std::int32_t i) {
    const Known* own = &known(i);
    if (own->owner == kNobody && own->searched < edges) {
      search(edges, i);
      own = &known(i);
    }
    const std::int32_t near = -std::int32_t(own->searched <= edges);  // all bits set, or none
    return (own->owner & near) | (kNobody & ~near);
  }
  // Searches up to `edges` away for the owner of node i. Suppose that the owner is d edges away
  // from i. Then a whole edge leads from i to a neighbour that has the same owner at a distance of
  // d - 1 edges. So the search looks at all neighbours to which a whole edge leads from i, and
  // finds those whose owner is d - 1 edges away. The owner of i is the particle with the lowest
  // index among the owners of these neighbours.
  void search(int edges, std::int32_t i);

  std::int64_t particleAt(const Vec3i& node) const;

  const Organ& organ_;
  IndexBox box_;
  TissueGrid& grid_;
  std::int32_t step_[6];              // index offset to the neighbour, by bit of ways()
  std::vector<std::int32_t> number_;  // per node of box_: index into known_, or kUnknown
  std::vector<Known> known_;
};

}  // namespace resect
