#include "surface/cell_kinds.h"

#include "surface/marching_cubes_table.h"

namespace resect {

const std::array<std::uint8_t, 256>& triangleCounts() {
  static const auto counts = [] {
    std::array<std::uint8_t, 256> all;
    for (std::size_t kind = 0; kind < 256; ++kind) all[kind] = marchingCubesTable()[kind].count;
    return all;
  }();
  return counts;
}

}  // namespace resect
