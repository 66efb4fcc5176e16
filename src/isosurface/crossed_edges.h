// The grid edges of a brick that cross the surface, and the numbering of their vertices. A brick is
// a block of 4 x 4 x 4 nodes of the colour field. A grid edge joins two neighbouring nodes.
//
// A vertex belongs to the grid edge on which it lies. A grid edge belongs to the brick that
// contains the edge's lower node. Within a brick an edge has the number 64 * axis + n, where n is
// the number of the edge's lower node. The crossed edges are stored as one 64-bit mask per axis.
// Vertices are numbered in the order of their edges. So the number of a vertex is the number of
// crossed edges before the vertex's edge. It is found by counting set bits of the masks.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "base/bit_list.h"
#include "sph/field_stencil.h"

namespace resect {

constexpr int kBrickEdges = 3 * kBrickSize;
constexpr std::uint8_t kNoEdge = kBrickEdges;  // in place of an edge number: no edge

// Which of the brick's 64 nodes are inside, and which of its 192 edges cross the surface.
struct BrickSigns {
  std::uint64_t inside = 0;                 // bit n: node n is inside
  std::array<std::uint64_t, 3> crossing{};  // per axis; bit n: edge with lower node n is crossed
  // For each axis, the number of the first vertex on an edge along this axis. The last element is
  // vertexCount().
  std::array<std::uint8_t, 4> firstVertex{};

  // Sets the masks of the crossed edges along x, y and z. Returns whether a mask has changed.
  bool setCrossing(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
    const bool changed = ((x ^ crossing[0]) | (y ^ crossing[1]) | (z ^ crossing[2])) != 0;
    crossing[0] = x, crossing[1] = y, crossing[2] = z;
    firstVertex[1] = std::uint8_t(std::popcount(x));
    firstVertex[2] = std::uint8_t(firstVertex[1] + std::popcount(y));
    firstVertex[3] = std::uint8_t(firstVertex[2] + std::popcount(z));
    return changed;
  }
  int vertexCount() const { return firstVertex[3]; }
  // Number within the brick of the vertex on the edge from `node` (0 to 63) along `axis`. The edge
  // must be crossed.
  int vertex(int axis, int node) const {
    return firstVertex[axis] + std::popcount(crossing[axis] & ((std::uint64_t(1) << node) - 1));
  }
};

// The numbers of the crossed edges, ascending, one per vertex. After these come kStep elements with
// the value kNoEdge, so that a loop may take kStep elements at a time.
struct CrossedEdges {
  static constexpr int kStep = 8, kMost = kBrickEdges + kStep;
  std::array<std::uint8_t, kMost> number;  // elements after the kNoEdge elements are not
                                           // initialised

  explicit CrossedEdges(const BrickSigns& signs) {
    std::uint8_t* end = number.data();
    for (unsigned axis = 0; axis < 3; ++axis)
      end = appendSetBits(signs.crossing[axis], axis * kBrickSize, end);
    std::memset(end, kNoEdge, kStep);
  }
};

}  // namespace resect
