// What piece of the iso-surface lies in one brick of the colour field?
//
// A vertex belongs to the grid edge that it lies on, and the edge to the brick of its lower node;
// the brick's vertices are numbered along x edges first, then y, then z, by counting bits below
// their own in a 64-bit mask. So neighbours find shared vertices with no search and no table of
// edges. Cost: a few hundred operations for a brick.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "base/vec.h"
#include "sph/colour_field.h"
#include "surface/cell_kinds.h"

namespace resect {

// Which of the brick's 64 nodes are inside, and which of its 192 edges cross the surface.
struct BrickSigns {
  std::uint64_t inside = 0;
  std::array<std::uint64_t, 3> crossing{};    // per axis, bit = lower node
  std::array<std::uint8_t, 4> firstVertex{};  // per axis: number of its first one; then the count

  void setCrossing(const std::array<std::uint64_t, 3>& edges) {
    crossing = edges;
    for (std::size_t a = 0; a < 3; ++a)
      firstVertex[a + 1] = std::uint8_t(firstVertex[a] + std::popcount(edges[a]));
  }
  int vertexCount() const { return firstVertex[3]; }
  // Number within the brick of the vertex on the edge from `node` (0..63) along `axis`.
  int vertex(int axis, int node) const {
    return firstVertex[axis] + std::popcount(crossing[axis] & ((std::uint64_t(1) << node) - 1));
  }
};

// A vertex of the surface: where, which way is out, how far below the original skin.
struct SurfaceVertex {
  Vec3f position;  // rest space, m
  Vec3f normal;    // unit, towards less tissue
  float cut;       // 0 on the original skin ... 1 well inside what was tissue before any cut
};

// Writes signs.vertexCount() vertices, each part of them into an array of its own; `normals` has
// room for up to three more, which are written too.
void brickVertices(const ColourField& field, const Vec3i& brick, const BrickSigns& signs, float iso,
                   Vec3f* points, Vec3f* normals, float* cut);

}  // namespace resect
