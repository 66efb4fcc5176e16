// The marching cubes table: triangles of a cell for each of the 256 cases of its corners.
//
// Corner c of a cell stands at (c & 1, c >> 1 & 1, c >> 2 & 1). Edges are numbered by axis: edge
// 4 * a + i runs along axis a and begins at the i-th of the four corners with coordinate 0 there.
//
// The table is computed. On each face of the cell one line separates each run of neighbouring
// inside corners from the rest, so two inside corners on a diagonal stay apart. The lines depend on
// the face alone; therefore neighbouring cells agree and the surface is closed. The lines of a cell
// link up to loops. Of the triangulations without a diagonal in a face of the cell, each loop gets
// the one with the best-shaped triangles. Source: Lorensen and Cline 1987 (the method); Durst 1988
// (its ambiguity).
#pragma once

#include <array>
#include <cstdint>

namespace resect {

struct CellTriangles {
  std::uint8_t count = 0;  // triangles, 0 to 5
  std::array<std::array<std::uint8_t, 3>, 5>
      edges{};  // of each triangle: three cell edges, counter-clockwise seen from outside
};

struct CellEdge {
  std::uint8_t axis, from, to;  // from the corner with coordinate 0 on the axis to the one with 1
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

// The table, indexed by the 8 corner bits (1 = inside). Made at first use in about a millisecond.
const std::array<CellTriangles, 256>& marchingCubesTable();

}  // namespace resect
