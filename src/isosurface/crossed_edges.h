// The grid edges of a brick that cross the surface, and the numbering of their vertices.
//
// A vertex belongs to the grid edge that it lies on, and the edge to the brick of its lower node.
// Within a brick an edge has the number 64 * axis + lower node. Vertices are numbered in the order
// of their edges, so the number of a vertex is the count of bits below its edge's own in a 64-bit
// mask: no search and no table of edges is needed.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "base/bit_list.h"
#include "sph/field_stencil.h"

namespace resect {

constexpr int kBrickEdges = 3 * kBrickSize;
constexpr std::uint8_t kNoEdge = kBrickEdges;  // stands for no edge

// Which of the brick's 64 nodes are inside, and which of its 192 edges cross the surface.
struct BrickSigns {
  std::uint64_t inside = 0;
  std::array<std::uint64_t, 3> crossing{};  // per axis, bit = lower node
  std::array<std::uint8_t, 4>
      firstVertex{};  // per axis: number of its first vertex; then the count

  // Sets the crossed edges, a mask per axis. Returns whether any of them has changed.
  bool setCrossing(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
    const bool changed = ((x ^ crossing[0]) | (y ^ crossing[1]) | (z ^ crossing[2])) != 0;
    crossing[0] = x, crossing[1] = y, crossing[2] = z;
    firstVertex[1] = std::uint8_t(std::popcount(x));
    firstVertex[2] = std::uint8_t(firstVertex[1] + std::popcount(y));
    firstVertex[3] = std::uint8_t(firstVertex[2] + std::popcount(z));
    return changed;
  }
  int vertexCount() const { return firstVertex[3]; }
  // Number within the brick of the vertex on the edge from `node` (0..63) along `axis`.
  int vertex(int axis, int node) const {
    return firstVertex[axis] + std::popcount(crossing[axis] & ((std::uint64_t(1) << node) - 1));
  }
};

// The numbers of the crossed edges, one per vertex, followed by kNoEdge up to the next multiple of
// kStep at least.
struct CrossedEdges {
  static constexpr int kStep = 8, kMost = kBrickEdges + kStep;
  std::array<std::uint8_t, kMost> number;  // beyond that: uninitialised

  explicit CrossedEdges(const BrickSigns& signs) {
    std::uint8_t* end = number.data();
    for (unsigned axis = 0; axis < 3; ++axis)
      end = appendSetBits(signs.crossing[axis], axis * kBrickSize, end);
    std::memset(end, kNoEdge, kStep);
  }
};

}  // namespace resect
