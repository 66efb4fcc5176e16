// Owners of grid nodes near cuts: the particle that each node goes with.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/index_box.h"
#include "organ/organ.h"

namespace resect {

// The nodes of a box that lie in tissue, and the whole grid edges between them, that is those that
// are not severed. Found on demand, brick by brick, for 64 nodes at a time.
class TissueGrid {
 public:
  // Serves the nodes of the box and those next to it. Nodes may lie outside the field.
  TissueGrid(const Organ& organ, const IndexBox& nodes);

  bool inTissue(const Vec3i& node) { return inside(brickOf(node)) >> bitOf(node) & 1; }
  // The whole edges from a node in tissue to other nodes in tissue, one bit each: bit 2 * axis, + 1
  // if the edge leads upwards.
  unsigned ways(const Vec3i& node);
  // Whether all edges are whole in a block of `side` grid cells along each axis, with `first` as
  // its lowest node.
  bool whole(const Vec3i& first, int side);

 private:
  struct Brick {
    bool insideKnown = false, wholeKnown = false, cellsKnown = false;
    // whole: edges per axis, bit = lower node; cells: those with twelve whole edges
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

// The owner of a grid node: the particle that is the fewest whole edges away, on a path through
// tissue; among equals the one with the lowest index. -1 if none is within kFar edges.
class NodeOwners {
 public:
  static constexpr int kFar = 6;  // edges

  // Serves the nodes of a box. grid: must cover the box and kFar nodes round it. Cost: four bytes
  // per node that the grid must cover, and work proportional to the nodes that searches visit.
  NodeOwners(const Organ& organ, TissueGrid& grid, const IndexBox& box);

  // node: in tissue.
  std::int64_t operator()(const Vec3i& node) {
    const std::int32_t owner = within(kFar, box_.index(node));
    return owner == kNobody ? -1 : owner;
  }

 private:
  static constexpr std::int32_t kNobody = std::numeric_limits<std::int32_t>::max(), kUnknown = -1;

  struct Known {
    std::int32_t owner = kNobody;
    // Radius searched so far, edges: the owner is known, or it is farther away.
    std::int8_t searched = 0;
    std::uint8_t ways;  // TissueGrid::ways() of the node
  };
  Known& known(std::int32_t i) {
    std::int32_t& number = number_[std::size_t(i)];
    if (number == kUnknown) number = lookAt(i);
    return known_[std::size_t(number)];
  }
  std::int32_t lookAt(std::int32_t i);

  // The owner of node i if it is at most `edges` away, else kNobody. The result is chosen without a
  // branch, which the processor could not predict.
  std::int32_t within(int edges, std::int32_t i) {
    const Known* own = &known(i);
    if (own->owner == kNobody && own->searched < edges) {
      search(edges, i);
      own = &known(i);
    }
    const std::int32_t near = -std::int32_t(own->searched <= edges);  // all bits set, or none
    return (own->owner & near) | (kNobody & ~near);
  }
  // Searches up to `edges` away for the owner of node i. A node has the same owner as a neighbour
  // that is one edge nearer to that owner.
  void search(int edges, std::int32_t i);

  std::int64_t particleAt(const Vec3i& node) const;

  const Organ& organ_;
  IndexBox box_;
  TissueGrid& grid_;
  std::int32_t step_[6];              // to the neighbour, by bit of ways()
  std::vector<std::int32_t> number_;  // per node, into known_
  std::vector<Known> known_;
};

}  // namespace resect
