// Triangles of a brick's cells, from the marching cubes table and the indices of vertices on edges.
//
// An edge table holds the vertex index of every edge that the brick's cells can use: the brick's
// own edges and those shared with the bricks above. A cell's four edges along an axis are two pairs
// of neighbouring entries, so six loads fetch the indices of all twelve edges; the cell's triangles
// are then a shuffle of these twelve.
#pragma once

#include <array>
#include <cstdint>

#include "geometry/triangle_mesh.h"
#include "isosurface/cell_kinds.h"

namespace resect {

struct EdgeTable {
  static constexpr int kSpan = kBrickNodes + 1;  // nodes 0 to 4 of the brick along each axis
  static constexpr int kAxis = kSpan * kSpan * kSpan, kNone = 3 * kAxis;
  std::array<std::int32_t, kNone + 1> vertex;  // at index(); kNone is the entry for no edge

  // Index of the edge that begins at node (x, y, z), each 0 to 4, and runs along `axis`. Entries
  // are ordered with y fastest for edges along x, with x fastest for others.
  static constexpr int index(int axis, int x, int y, int z) {
    return axis * kAxis + (z * kSpan + (axis == 0 ? x : y)) * kSpan + (axis == 0 ? y : x);
  }
  // Index of an edge of a cell (edge: as numbered in isosurface/marching_cubes_table.h).
  static int ofCell(int cell, int edge);
};

// Writes the triangles of `cells` (one bit per cell) from `out` on and returns their end. The
// memory from there to `limit` may be overwritten.
Triangle* drawCells(const EdgeTable& table, const CellKinds& kinds, std::uint64_t cells,
                    Triangle* out, const Triangle* limit);
// The same edge by edge, for machines without AVX2.
Triangle* drawCellsPlainly(const EdgeTable& table, const CellKinds& kinds, std::uint64_t cells,
                           Triangle* out);

}  // namespace resect
