// Which vertices do the triangles of a brick's cells join?
//
// The numbers of the vertices stand in a table of all edges that the brick's cells can use: its own
// and those that it shares with the bricks above. A cell's four edges along an axis lie in two
// pairs of neighbours there, so that all twelve come as six loads, and its triangles as a choice
// among twelve.
#pragma once

#include <array>
#include <cstdint>

#include "geometry/triangle_mesh.h"
#include "isosurface/cell_kinds.h"

namespace resect {

struct EdgeTable {
  static constexpr int kSpan = kBrickNodes + 1;  // nodes 0 to 4 of the brick along each axis
  static constexpr int kAxis = kSpan * kSpan * kSpan, kNone = 3 * kAxis;
  std::array<std::int32_t, kNone + 1> vertex;  // by place(); kNone stands for no edge

  // Of the edge along an axis from a node, each coordinate 0 to 4: y before x for edges along x, x
  // before y for others.
  static constexpr int place(int axis, int x, int y, int z) {
    return axis * kAxis + (z * kSpan + (axis == 0 ? x : y)) * kSpan + (axis == 0 ? y : x);
  }
  // Of a cell's edge (isosurface/marching_cubes_table.h).
  static int ofCell(int cell, int edge);
};

// Draws the triangles of `cells`, one after the other; returns their end. Between it and `limit`
// anything may be written.
Triangle* drawCells(const EdgeTable& table, const CellKinds& kinds, std::uint64_t cells,
                    Triangle* out, const Triangle* limit);
// The same edge by edge, as machines without AVX2 draw them.
Triangle* drawCellsPlainly(const EdgeTable& table, const CellKinds& kinds, std::uint64_t cells,
                           Triangle* out);

}  // namespace resect
