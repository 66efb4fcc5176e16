// Occupancy masks: two bits per cell. The bit "any" is set if the cell holds some tissue, the bit
// "full" if the cell is full. The bits are stored in rows of 64-bit words, so that one operation
// combines the bits of 64 cells.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/raw_array.h"

namespace resect {

// The masks of many rows of cells. For each row, the words of the "any" bits are stored first, then
// the words of the "full" bits. Bits beyond the row's last cell must be zero.
struct HeldBits {
  static constexpr std::size_t kWord = 64;  // cells per word
  static constexpr std::size_t kChunk = 4;  // words that are combined at once
  // words: number of words of one mask for one row of cells. row: number of words of both masks for
  // one row of cells, rounded up to a multiple of kChunk.
  std::size_t words = 0, row = 0;
  RawArray<std::uint64_t> bits;  // `row` words per row of cells; the caller writes them

  HeldBits() = default;
  HeldBits(std::size_t rows, std::size_t cells)
      : words((cells + kWord - 1) / kWord),
        row((2 * words + kChunk - 1) / kChunk * kChunk),
        bits(rows * row) {}
};

// Combines the masks of all cells of a box, for every position of the box along a row of cells. The
// box that begins at cell i of the row has two results. Bit i of the words from bits[0] on is set
// if any cell of the box holds tissue. Bit i of the words from bits[held.words] on is set if any
// cell of the box is not full. width, rows, planes: number of cells of the box along x, y and z.
// first: number of the row where the box begins. perPlane: number of rows of cells in a plane of
// cells, including the rows of empty cells round the lattice. bits: room for held.row words.
void holdTogether(const HeldBits& held, std::size_t first, int rows, int planes,
                  std::size_t perPlane, int width, std::uint64_t* bits);

}  // namespace resect
