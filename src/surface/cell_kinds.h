// Which corners of a brick's 64 cells are inside? All cells at once, as bits.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "sph/field_stencil.h"

namespace resect {

// Which of a brick's 64 nodes are inside (value >= iso)? Bit = node, x fastest.
std::uint64_t insideMask(std::span<const float, kBrickSize> nodes, float iso);

// Which corners of its 64 cells are inside, given the inside masks of the brick and of its seven
// neighbours above (number: 1 for a step along x, 2 along y, 4 along z)? Mask c holds corner c, bit
// = cell; corner 0 is the brick's own mask.
std::array<std::uint64_t, 8> cornerMasks(const std::array<std::uint64_t, 8>& inside);

// The cells that the surface runs through: those with corners on both sides.
inline std::uint64_t crossedCells(const std::array<std::uint64_t, 8>& corners) {
  std::uint64_t any = 0, all = ~std::uint64_t(0);
  for (const std::uint64_t mask : corners) any |= mask, all &= mask;
  return any & ~all;
}

// Per cell its eight corner bits: the same 512 bits, cell by cell.
using CellKinds = std::array<std::uint8_t, kBrickSize>;
CellKinds cellKinds(const std::array<std::uint64_t, 8>& corners);

// How many triangles marching cubes draws in `cells`.
int countTriangles(const CellKinds& kinds, std::uint64_t cells);

}  // namespace resect
