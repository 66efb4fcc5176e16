#include "sph/held_bits.h"

#include <cstring>

#include "base/instruction_set.h"

namespace resect {
namespace {

// Combines the box's rows cell by cell: any tissue; not full. Aims at 6 instructions for 256 bits
// of a row.
RESECT_WIDEST
void holdOfRows(const HeldBits& held, std::size_t first, int rows, int planes, std::size_t perPlane,
                std::uint64_t* bits) {
  for (std::size_t chunk = 0; chunk < held.row; chunk += HeldBits::kChunk) {
    std::uint64_t any[HeldBits::kChunk] = {}, lacking[HeldBits::kChunk];
    for (std::size_t k = 0; k < HeldBits::kChunk; ++k)
      lacking[k] = chunk + k < held.words ? 0 : ~std::uint64_t(0);
    for (int z = 0; z < planes; ++z) {
      const std::uint64_t* row =
          held.bits.data() + (first + std::size_t(z) * perPlane) * held.row + chunk;
      for (int y = 0; y < rows; ++y, row += held.row)
        for (std::size_t k = 0; k < HeldBits::kChunk; ++k) any[k] |= row[k] ^ lacking[k];
    }
    std::memcpy(bits + chunk, any, sizeof any);
  }
}

// For each start in a row: combines `width` consecutive cells.
void holdAlong(std::size_t words, int width, std::uint64_t* bits) {
  for (std::size_t w = 0; w < words; ++w) {
    const std::uint64_t here = bits[w], next = w + 1 < words ? bits[w + 1] : 0;
    for (int k = 1; k < width; ++k) bits[w] |= here >> k | next << (64 - k);
  }
}

}  // namespace

void holdTogether(const HeldBits& held, std::size_t first, int rows, int planes,
                  std::size_t perPlane, int width, std::uint64_t* bits) {
  holdOfRows(held, first, rows, planes, perPlane, bits);
  holdAlong(held.words, width, bits);
  holdAlong(held.words, width, bits + held.words);
}

}  // namespace resect
