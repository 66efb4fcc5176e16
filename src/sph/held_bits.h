// What do cells hold: anything at all, and all they can? Two bits a cell, in rows of words, so that
// 64 cells are combined at once.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/raw_array.h"

namespace resect {

// Of each row first the words of the one, then those of the other. Cells that are not there hold
// nothing: zeros.
struct HeldBits {
  static constexpr std::size_t kWord = 64;  // cells
  static constexpr std::size_t kChunk = 4;  // words that are combined at once
  std::size_t words = 0, row = 0;           // words of either kind, and of both, rounded up
  RawArray<std::uint64_t> bits;             // not written yet

  HeldBits() = default;
  HeldBits(std::size_t rows, std::size_t cells)
      : words((cells + kWord - 1) / kWord),
        row((2 * words + kChunk - 1) / kChunk * kChunk),
        bits(rows * row) {}
};

// What the cells of a box hold together, which is `width` cells wide and begins at each cell of a
// row in turn: bits[i / 64] >> i % 64 & 1: anything; the same `words` further: less than all.
// first: row where the box begins; rows, planes: of it; perPlane: rows. bits: one row.
void holdTogether(const HeldBits& held, std::size_t first, int rows, int planes,
                  std::size_t perPlane, int width, std::uint64_t* bits);

}  // namespace resect
