// Triangles of a brick's cells, from the marching cubes table and the indices of vertices on edges.
//
// An EdgeTable holds the index of the vertex on every edge that the brick's cells can use: the
// brick's own edges, and the edges shared with its neighbours in the positive directions. The four
// edges of a cell along one axis occupy two pairs of neighbouring entries of the table. So six
// loads, each of one pair, fetch the indices for all twelve edges of a cell. A shuffle of these
// twelve indices gives the corners of the cell's triangles.
#pragma once

#include <array>
#include <cstdint>

#include "geometry/triangle_mesh.h"
#include "isosurface/cell_kinds.h"

namespace resect {

struct EdgeTable {
  static constexpr int kSpan = kBrickNodes + 1;  // nodes 0 to 4 of the brick along each axis
  static constexpr int kAxis = kSpan * kSpan * kSpan, kNone = 3 * kAxis;
  std::array<std::int32_t, kNone + 1> vertex;  // by index(); entry kNone belongs to no edge

  // Index of the edge that begins at node (x, y, z), each 0 to 4, and runs along `axis`. Entries of
  // edges along x are ordered with y fastest; entries of edges along y or z are ordered with x
  // fastest.
  static constexpr int index(int axis, int x, int y, int z) {
    return axis * kAxis + (z * kSpan + (axis == 0 ? x : y)) * kSpan + (axis == 0 ? y : x);
  }
  // Index of an edge of a cell. edge: its number in isosurface/marching_cubes_table.h.
  static int ofCell(int cell, int edge);
};

// Writes the triangles of `cells` (one bit per cell) from `out` on. Returns the end of the written
// triangles. The memory from there to `limit` may be overwritten.
Triangle* drawCells(const EdgeTable& table, const CellKinds& kinds, std::uint64_t cells,
                    Triangle* out, const Triangle* limit);
// Does the same for machines without AVX2, one corner of a triangle after the other. Overwrites
// nothing beyond the returned end.
Triangle* drawCellsPlainly(const EdgeTable& table, const CellKinds& kinds, std::uint64_t cells,
                           Triangle* out);

}  // namespace resect
