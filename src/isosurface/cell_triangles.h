// Triangles of a brick's cells, from the marching cubes table and the indices of vertices on edges.
//
// A table holds the vertex index of every edge that the brick's cells can use: its own edges and
// those shared with the bricks above. A cell's four edges along an axis are two pairs of neighbours
// in the table, so all twelve take six loads; its triangles are then a shuffle of these twelve.
#pragma once

#include <array>
#include <cstdint>

#include "geometry/triangle_mesh.h"
#include "isosurface/cell_kinds.h"

namespace resect {

struct EdgeTable {
  static constexpr int kSpan = kBrickNodes + 1;  // nodes 0 to 4 of the brick along each axis
  static constexpr int kAxis = kSpan * kSpan * kSpan, kNone = 3 * kAxis;
  std::array<std::int32_t, kNone + 1> vertex;  // by index(); entry kNone stands for no edge

  // Index of the edge along an axis from a node, whose coordinates are 0 to 4: y fastest for edges
  // along x, x fastest for others.
  static constexpr int index(int axis, int x, int y, int z) {
    return axis * kAxis + (z * kSpan + (axis == 0 ? x : y)) * kSpan + (axis == 0 ? y : x);
  }
  // Index of a cell's edge (isosurface/marching_cubes_table.h).
  static int ofCell(int cell, int edge);
};

// Writes the triangles of `cells`; returns their end. The rest up to `limit` may be overwritten.
Triangle* drawCells(const EdgeTable& table, const CellKinds& kinds, std::uint64_t cells,
                    Triangle* out, const Triangle* limit);
// The same edge by edge, for machines without AVX2.
Triangle* drawCellsPlainly(const EdgeTable& table, const CellKinds& kinds, std::uint64_t cells,
                           Triangle* out);

}  // namespace resect
