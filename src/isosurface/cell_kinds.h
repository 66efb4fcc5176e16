// Marching cubes cases of a brick's 64 cells. The case of a cell says which of the cell's corners
// are inside. Bit operations find the cases of all cells at once. A brick is a block of 4 x 4 x 4
// nodes; each node is the lowest corner of one of the cells.
//
// The functions are inlined, so that they are compiled for the instruction set of their caller.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>

#include "base/flag_bits.h"
#include "sph/field_stencil.h"

namespace resect {

// Keeps the compiler from loading several words as one vector. Suppose that the words were stored
// one by one just before. Then the processor cannot forward the stored words to such a load, and
// the load waits until all these stores are done. The wait would take as long as all work on the 64
// cells.
[[gnu::always_inline]] inline std::uint64_t keptAlone(std::uint64_t word) {
  asm("" : "+r"(word));
  return word;
}

// Which of a brick's 64 nodes are inside (value >= iso). Bit n is for node n; x is fastest.
[[gnu::always_inline]] inline std::uint64_t insideMask(std::span<const float, kBrickSize> nodes,
                                                       float iso) {
  return compared64(nodes.data(), [iso](const FourValues& v) -> FourFlags { return v >= iso; });
}

// Which corners of the 64 cells are inside. `inside`: the inside masks of the brick and of its
// seven upper neighbours, which lie next to it in the positive directions. The brick has index 0.
// The index of a neighbour is a sum: 1 if the neighbour is shifted along x, plus 2 if it is shifted
// along y, plus 4 if it is shifted along z. Mask c of the result has one bit per cell: whether
// corner c of the cell is inside. The corners of a cell are numbered in the same way as the
// neighbours. Mask 0 is the brick's own inside mask.
[[gnu::always_inline]] inline std::array<std::uint64_t, 8> cornerMasks(
    const std::array<std::uint64_t, 8>& inside) {
  // The mask `own` shifted by one node along an axis; bits of the neighbour's mask fill the gap.
  const auto alongX = [](std::uint64_t own, std::uint64_t next) {
    return (own >> 1 & 0x7777777777777777) | (next & 0x1111111111111111) << 3;
  };
  const auto alongY = [](std::uint64_t own, std::uint64_t next) {
    return (own >> 4 & 0x0fff0fff0fff0fff) | (next & 0x000f000f000f000f) << 12;
  };
  const auto alongZ = [](std::uint64_t own, std::uint64_t next) { return own >> 16 | next << 48; };
  // Written word by word, so crossedCells() reads single words too (keptAlone() says why).
  std::array<std::uint64_t, 8> mask;
#pragma GCC unroll 4
  for (std::size_t d = 0; d < 8; d += 2) {
    mask[d] = inside[d];
    mask[d + 1] = alongX(inside[d], inside[d + 1]);
  }
  for (const int d : {0, 1, 4, 5}) mask[d + 2] = alongY(mask[d], mask[d + 2]);
  for (const int d : {0, 1, 2, 3}) mask[d + 4] = alongZ(mask[d], mask[d + 4]);
  return mask;
}

// The cells that the surface crosses: those with at least one corner inside and one outside.
inline std::uint64_t crossedCells(const std::array<std::uint64_t, 8>& corners) {
  std::uint64_t any = 0, all = ~std::uint64_t(0);
  for (const std::uint64_t mask : corners) {
    const std::uint64_t alone = keptAlone(mask);
    any |= alone, all &= alone;
  }
  return any & ~all;
}

namespace bits {

typedef std::uint8_t Bytes __attribute__((vector_size(16)));
typedef std::uint16_t Pairs __attribute__((vector_size(16)));
typedef std::uint32_t Fours __attribute__((vector_size(16)));
typedef std::uint64_t Words __attribute__((vector_size(16)));

// Transposes each word as a matrix of 8 x 8 bits, by swapping blocks of one, two and four bits
// (Knuth, The Art of Computer Programming 4A, 7.1.3).
[[gnu::always_inline]] inline Words transposeBits(Words w) {
  const auto swap = [&w](int way, std::uint64_t which) {
    const Words moved = (w ^ w >> way) & which;
    w ^= moved ^ moved << way;
  };
  swap(7, 0x00aa00aa00aa00aa);
  swap(14, 0x0000cccc0000cccc);
  swap(28, 0x00000000f0f0f0f0);
  return w;
}

}  // namespace bits

// The case of each cell: its eight corner bits.
using CellKinds = std::array<std::uint8_t, kBrickSize>;

// Transposes the eight masks of cornerMasks() to 64 bytes, one per cell. First the bytes of the
// masks are interleaved, so that a 64-bit word holds all corners of eight cells. Then each word is
// transposed as a matrix of bits. Cost: some 120 instructions.
[[gnu::always_inline]] inline CellKinds cellKinds(const std::array<std::uint64_t, 8>& corners) {
  bits::Pairs two[4];  // corners 2 k and 2 k + 1 of cells 0 to 7, 8 to 15, ...
  for (std::size_t k = 0; k < 4; ++k) {
    const auto b = bits::Bytes(bits::Words{corners[2 * k], corners[2 * k + 1]});
    two[k] = bits::Pairs(
        __builtin_shufflevector(b, b, 0, 8, 1, 9, 2, 10, 3, 11, 4, 12, 5, 13, 6, 14, 7, 15));
  }
  bits::Fours four[2][2];  // [which corners][which cells]
  for (int k = 0; k < 2; ++k) {
    four[k][0] =
        bits::Fours(__builtin_shufflevector(two[2 * k], two[2 * k + 1], 0, 8, 1, 9, 2, 10, 3, 11));
    four[k][1] = bits::Fours(
        __builtin_shufflevector(two[2 * k], two[2 * k + 1], 4, 12, 5, 13, 6, 14, 7, 15));
  }
  CellKinds kinds;
  for (int half = 0; half < 2; ++half) {
    const bits::Fours &low = four[0][half], &high = four[1][half];
    const bits::Words all[2] = {
        bits::transposeBits(bits::Words(__builtin_shufflevector(low, high, 0, 4, 1, 5))),
        bits::transposeBits(bits::Words(__builtin_shufflevector(low, high, 2, 6, 3, 7)))};
    std::memcpy(kinds.data() + 32 * half, all, sizeof all);
  }
  return kinds;
}

// For each case: the number of triangles, minus the number of crossed edges, plus 2. The surface
// meets the faces of a cell in closed loops of lines (isosurface/marching_cubes_table.h). A loop
// through n crossed edges gives n - 2 triangles. So the value is 0 for a case with one loop, and
// each further loop lowers the value by 2. For a case without crossed edges the formula would give
// 2, but the value is 0.
const std::array<std::int8_t, 256>& trianglesBeyondOneLoop();

// Number of triangles in the cells of the mask `cells`; the surface must cross all these cells. c:
// as given by cornerMasks(). A cell can have several loops only under one of two conditions:
// - On one of its faces, exactly two corners are inside, and these are diagonally opposite.
// - Each of two opposite corners of the cell differs from all three corners to which an edge joins
//   it. (Two corners differ if exactly one of the two is inside.)
// Such cells are few. For these cells the value from trianglesBeyondOneLoop() is added. Cost: some
// 110 instructions.
[[gnu::always_inline]] inline int countTriangles(const std::array<std::uint64_t, 8>& c,
                                                 std::uint64_t cells) {
  // Crossed edges along x, y and z, by their lower corners.
  const std::uint64_t x[4] = {c[0] ^ c[1], c[2] ^ c[3], c[4] ^ c[5], c[6] ^ c[7]},
                      y[4] = {c[0] ^ c[2], c[1] ^ c[3], c[4] ^ c[6], c[5] ^ c[7]},
                      z[4] = {c[0] ^ c[4], c[1] ^ c[5], c[2] ^ c[6], c[3] ^ c[7]};
  int count = -2 * std::popcount(cells);
  for (int i = 0; i < 4; ++i)
    count +=
        std::popcount(x[i] & cells) + std::popcount(y[i] & cells) + std::popcount(z[i] & cells);
  const std::uint64_t faces = (x[0] & x[1] & y[0] & y[1]) | (x[2] & x[3] & y[2] & y[3]) |
                              (x[0] & x[2] & z[0] & z[1]) | (x[1] & x[3] & z[2] & z[3]) |
                              (y[0] & y[2] & z[0] & z[2]) | (y[1] & y[3] & z[1] & z[3]);
  const std::uint64_t opposite =
      (x[0] & y[0] & z[0] & x[3] & y[3] & z[3]) | (x[0] & y[1] & z[1] & x[3] & y[2] & z[2]) |
      (x[1] & y[0] & z[2] & x[2] & y[3] & z[1]) | (x[1] & y[1] & z[3] & x[2] & y[2] & z[0]);
  for (std::uint64_t rest = (faces | opposite) & cells; rest != 0; rest &= rest - 1) {
    const int cell = std::countr_zero(rest);
    unsigned kind = 0;
    for (unsigned corner = 0; corner < 8; ++corner)
      kind |= unsigned(c[corner] >> cell & 1) << corner;
    count += trianglesBeyondOneLoop()[kind];
  }
  return count;
}

}  // namespace resect
