// The marching cubes table: the triangles of a cell for each of the 256 cases of its corners.
//
// Corner c of a cell stands at (c & 1, c >> 1 & 1, c >> 2 & 1). Edges are numbered axis by axis.
// The four edges along axis a have the numbers 4 * a to 4 * a + 3. Each of these edges begins at a
// corner whose coordinate along a is 0; the edges have the same order as these corners.
//
// The table is computed. On each face of the cell, inside corners that are neighbours form a run.
// One line separates each run from the rest of the face, so two inside corners on a diagonal stay
// apart. The lines on a face depend only on which of the face's corners are inside. So the two
// cells that share a face have the same lines on it, and the surface is closed. The lines on all
// faces of a cell form closed loops, and each loop is triangulated. A triangulation is excluded if
// it has a diagonal in a face of the cell. From the remaining triangulations, the one with the
// best-shaped triangles is chosen. Source: Lorensen and Cline 1987 (the method); Durst 1988
// (ambiguous faces in the original table).
#pragma once

#include <array>
#include <cstdint>

namespace resect {

struct CellTriangles {
  std::uint8_t count = 0;  // number of triangles, 0 to 5
  // Per triangle: the numbers of the cell edges on which its corners lie, in counter-clockwise
  // order as seen from outside the tissue.
  std::array<std::array<std::uint8_t, 3>, 5> edges{};
};

struct CellEdge {
  // The corners at its ends: `from` has coordinate 0 along the axis, `to` has 1.
  std::uint8_t axis, from, to;
};

constexpr std::array<CellEdge, 12> kCellEdges = [] {
  std::array<CellEdge, 12> edges{};
  int n = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (int corner = 0; corner < 8; ++corner)
      if (!(corner >> axis & 1))
        edges[n++] = {std::uint8_t(axis), std::uint8_t(corner), std::uint8_t(corner | 1 << axis)};
  return edges;
}();

// The table, indexed by the 8 corner bits (1 = inside). Made at the first call, in about a
// millisecond.
const std::array<CellTriangles, 256>& marchingCubesTable();

}  // namespace resect
