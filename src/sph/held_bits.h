// Occupancy masks: two bits per cell, whether it holds any tissue ("any") and whether it is full
// ("full"). They are stored in rows of 64-bit words, so that 64 cells are combined at once.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/raw_array.h"

namespace resect {

// Each row has first the words of the "any" bits, then those of the "full" bits. Bits beyond the
// row's last cell are zero.
struct HeldBits {
  static constexpr std::size_t kWord = 64;  // cells of a word
  static constexpr std::size_t kChunk = 4;  // words that are combined at once
  // words: words of one mask in a row. row: words of both, rounded up to a multiple of kChunk.
  std::size_t words = 0, row = 0;
  RawArray<std::uint64_t> bits;  // `row` words for each row; uninitialised

  HeldBits() = default;
  HeldBits(std::size_t rows, std::size_t cells)
      : words((cells + kWord - 1) / kWord),
        row((2 * words + kChunk - 1) / kChunk * kChunk),
        bits(rows * row) {}
};

// Combined occupancy of a box of cells, for every position of the box along a row. The box that
// begins at cell i of the row gives two results: bit i of `bits` is set if any of its cells holds
// tissue; bit i of the words from held.words on is set if any of its cells is not full. width,
// rows, planes: cells of the box along x, y and z. first: the row where the box begins. perPlane:
// rows in a plane of the lattice. bits: room for held.row words.
void holdTogether(const HeldBits& held, std::size_t first, int rows, int planes,
                  std::size_t perPlane, int width, std::uint64_t* bits);

}  // namespace resect
