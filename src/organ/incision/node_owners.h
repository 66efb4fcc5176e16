// Which particle does a node of the grid go with, where cuts run through the tissue?
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/index_box.h"
#include "organ/organ.h"

namespace resect {

// Which nodes of a box lie in tissue, and which whole edges lead from one to the next? Found brick
// by brick, 64 nodes at a time, where asked.
class TissueGrid {
 public:
  // For the nodes of the box and those beside it, which may lie outside the field.
  TissueGrid(const Organ& organ, const IndexBox& nodes);

  bool inTissue(const Vec3i& node) { return inside(brickOf(node)) >> bitOf(node) & 1; }
  // The whole edges from a node in tissue to others in tissue: bit 2 axis + up.
  unsigned ways(const Vec3i& node);
  // Are all edges of the `side` cells of the grid along each axis from a node on whole?
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

// The particle that a node of the grid goes with: the one fewest whole edges away through tissue;
// of several the first. -1 when none is within kFar.
class NodeOwners {
 public:
  static constexpr int kFar = 6;  // edges

  // For the nodes of a box; grid: for it and kFar nodes round it. Cost: four bytes per node of
  // both, and work in proportion to those that a search comes by.
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
    std::int8_t searched = 0;  // edges: there is no owner within them, or it is found
    std::uint8_t ways;         // as of TissueGrid
  };
  Known& known(std::int32_t i) {
    std::int32_t& number = number_[std::size_t(i)];
    if (number == kUnknown) number = lookAt(i);
    return known_[std::size_t(number)];
  }
  std::int32_t lookAt(std::int32_t i);

  // The owner if it is so many edges away at most, without a branch that goes one way as often as
  // the other.
  std::int32_t within(int edges, std::int32_t i) {
    const Known* own = &known(i);
    if (own->owner == kNobody && own->searched < edges) {
      search(edges, i);
      own = &known(i);
    }
    const std::int32_t near = -std::int32_t(own->searched <= edges);  // all bits
    return (own->owner & near) | (kNobody & ~near);
  }
  // It is that of a neighbour which has one an edge less away.
  void search(int edges, std::int32_t i);

  std::int64_t particleAt(const Vec3i& node) const;

  const Organ& organ_;
  IndexBox box_;
  TissueGrid& grid_;
  std::int32_t step_[6];              // by way
  std::vector<std::int32_t> number_;  // per node, into known_
  std::vector<Known> known_;
};

}  // namespace resect
