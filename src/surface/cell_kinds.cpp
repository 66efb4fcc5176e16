#include "surface/cell_kinds.h"

#include <bit>
#include <cstring>

#include "base/flag_bits.h"
#include "base/instruction_set.h"
#include "surface/marching_cubes_table.h"

namespace resect {
namespace {

typedef std::uint8_t Bytes __attribute__((vector_size(16)));
typedef std::uint16_t Pairs __attribute__((vector_size(16)));
typedef std::uint32_t Fours __attribute__((vector_size(16)));
typedef std::uint64_t Words __attribute__((vector_size(16)));

// Each word as eight rows of eight bits: rows and columns change places, by blocks of one bit, two
// and four (Knuth, The Art of Computer Programming 4A, 7.1.3).
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

}  // namespace

RESECT_WIDEST
std::uint64_t insideMask(std::span<const float, kBrickSize> nodes, float iso) {
  alignas(32) std::uint8_t flags[kBrickSize];
  for (std::size_t node = 0; node < kBrickSize; ++node) flags[node] = nodes[node] >= iso ? 255 : 0;
  return flagBits(flags);
}

std::array<std::uint64_t, 8> cornerMasks(const std::array<std::uint64_t, 8>& inside) {
  // The masks one node further along an axis: bits move down, those of the neighbour come in.
  const auto alongX = [](std::uint64_t own, std::uint64_t next) {
    return (own >> 1 & 0x7777777777777777) | (next & 0x1111111111111111) << 3;
  };
  const auto alongY = [](std::uint64_t own, std::uint64_t next) {
    return (own >> 4 & 0x0fff0fff0fff0fff) | (next & 0x000f000f000f000f) << 12;
  };
  const auto alongZ = [](std::uint64_t own, std::uint64_t next) { return own >> 16 | next << 48; };
  std::array<std::uint64_t, 8> mask = inside;
  for (const int d : {0, 2, 4, 6}) mask[d + 1] = alongX(inside[d], inside[d + 1]);
  for (const int d : {0, 1, 4, 5}) mask[d + 2] = alongY(mask[d], mask[d + 2]);
  for (const int d : {0, 1, 2, 3}) mask[d + 4] = alongZ(mask[d], mask[d + 4]);
  return mask;
}

// The bytes of the eight masks are laid side by side, eight cells of all corners to a word; then
// the bits of each word are turned. Aims at 120 instructions.
RESECT_WIDEST
CellKinds cellKinds(const std::array<std::uint64_t, 8>& corners) {
  Pairs two[4];  // corners 2 k and 2 k + 1 of cells 0 to 7, 8 to 15, ...
  for (std::size_t k = 0; k < 4; ++k) {
    Bytes b;
    std::memcpy(&b, &corners[2 * k], sizeof b);
    two[k] =
        Pairs(__builtin_shufflevector(b, b, 0, 8, 1, 9, 2, 10, 3, 11, 4, 12, 5, 13, 6, 14, 7, 15));
  }
  Fours four[2][2];  // [which corners][which cells]
  for (int k = 0; k < 2; ++k) {
    four[k][0] =
        Fours(__builtin_shufflevector(two[2 * k], two[2 * k + 1], 0, 8, 1, 9, 2, 10, 3, 11));
    four[k][1] =
        Fours(__builtin_shufflevector(two[2 * k], two[2 * k + 1], 4, 12, 5, 13, 6, 14, 7, 15));
  }
  CellKinds kinds;
  for (int half = 0; half < 2; ++half) {
    const Fours &low = four[0][half], &high = four[1][half];
    const Words all[2] = {transposeBits(Words(__builtin_shufflevector(low, high, 0, 4, 1, 5))),
                          transposeBits(Words(__builtin_shufflevector(low, high, 2, 6, 3, 7)))};
    std::memcpy(kinds.data() + 32 * half, all, sizeof all);
  }
  return kinds;
}

int countTriangles(const CellKinds& kinds, std::uint64_t cells) {
  const auto& table = marchingCubesTable();
  int count = 0;
  for (; cells != 0; cells &= cells - 1)
    count += table[kinds[std::size_t(std::countr_zero(cells))]].count;
  return count;
}

}  // namespace resect
