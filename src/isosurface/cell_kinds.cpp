#include "isosurface/cell_kinds.h"

#include <bit>

#include "isosurface/marching_cubes_table.h"

namespace resect {

const std::array<std::int8_t, 256>& trianglesBeyondOneLoop() {
  static const auto beyond = [] {
    std::array<std::int8_t, 256> all;
    for (unsigned kind = 0; kind < 256; ++kind) {
      int edges = 0;
      for (const CellEdge& edge : kCellEdges) edges += (kind >> edge.from ^ kind >> edge.to) & 1;
      all[kind] = std::int8_t(edges == 0 ? 0 : marchingCubesTable()[kind].count - (edges - 2));
    }
    return all;
  }();
  return beyond;
}

}  // namespace resect
