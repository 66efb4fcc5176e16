// Occupancy masks: two bits per cell, whether it holds any tissue and whether it is full, in rows
// of words so that 64 cells are combined at once.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/raw_array.h"

namespace resect {

// Each row has first the words of the "any" bits, then those of the "full" bits. Bits beyond the
// cells are zero.
struct HeldBits {
  static constexpr std::size_t kWord = 64;  // cells
  static constexpr std::size_t kChunk = 4;  // words that are combined at once
  std::size_t words = 0, row = 0;           // words per row of either mask; of both, rounded up
  RawArray<std::uint64_t> bits;             // uninitialised

  HeldBits() = default;
  HeldBits(std::size_t rows, std::size_t cells)
      : words((cells + kWord - 1) / kWord),
        row((2 * words + kChunk - 1) / kChunk * kChunk),
        bits(rows * row) {}
};

// Combined occupancy of a box `width` cells wide, for each start i of the box along a row: bit i of
// `bits` is set if any cell of the box holds tissue; bit i of the words from `words` on is set if
// any cell is not full. first: row where the box begins; rows, planes: size of the box; perPlane:
// rows in a plane of the lattice. bits: room for one row.
void holdTogether(const HeldBits& held, std::size_t first, int rows, int planes,
                  std::size_t perPlane, int width, std::uint64_t* bits);

}  // namespace resect
