#include "sph/padded_cells.h"

#include <algorithm>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

#include "base/flag_bits.h"
#include "base/growth.h"
#include "base/parallel.h"

namespace resect {
namespace {

constexpr std::size_t kPlanes = 4;  // planes per block of work
// Prefetch distance in bytes: a large organ's cells come from memory, and rows are too short for
// the hardware prefetcher.
constexpr std::size_t kAhead = 2048, kLine = 64;
constexpr std::size_t kStep = 32;  // bytes that are copied at once
constexpr std::size_t kWord = HeldBits::kWord;
constexpr std::size_t kBehind = 16;  // cells beyond the last one that may be read
constexpr std::size_t kAdded = PaddedCells::kBelow + PaddedCells::kAbove;

// Occupancy of 64 cells: which hold any tissue, which are full. Bit = cell.
struct HeldBy64 {
  std::uint64_t some, full;
};

[[gnu::always_inline]] inline HeldBy64 heldBy64(const std::uint8_t* levels) {
  static_assert(kFullLevel == 0x80);  // no other level has its upper bit set
  return {nonZero64(levels), upperBits64(levels)};
}
[[gnu::always_inline]] inline HeldBy64 heldBy64(const float* numbers) {
  return {compared64(numbers, [](const FourValues& v) -> FourFlags { return v != 0.f; }),
          compared64(numbers, [](const FourValues& v) -> FourFlags { return v == 100.f; })};
}

// Masks for a row of `count` cells with halo: bits of the cells are set, those of the halo are not.
std::vector<std::uint64_t> bitsOfCells(std::size_t count, std::size_t words) {
  std::vector<std::uint64_t> bits(words, 0);
  for (std::size_t i = PaddedCells::kBelow; i < PaddedCells::kBelow + count; ++i)
    bits[i / kWord] |= std::uint64_t(1) << i % kWord;
  return bits;
}

// Copies a row of cells and the empty cells after it, and finds the occupancy masks. Up to kStep
// bytes more may be written. `from` must be readable from kBelow cells before the row on, for
// ofCells.size() words of cells. Reads the source only, since loads from just written memory would
// stall. Aims at 40 instructions for 64 cells.
template <typename Cell>
[[gnu::always_inline]] inline void layRow(const Cell* from, std::size_t width,
                                          std::span<const std::uint64_t> ofCells, Cell* to,
                                          std::uint64_t* bits) {
  for (std::size_t i = 0; i < width; i += kLine / sizeof(Cell)) {
    __builtin_prefetch(from + i + kAhead / sizeof(Cell));
    __builtin_prefetch(to + i + kAhead / sizeof(Cell), 1);
  }
  for (std::size_t i = 0; i < width; i += kStep / sizeof(Cell))
    std::memcpy(to + i, from + i, kStep);
  std::memset(to + width, 0, kAdded * sizeof(Cell));
  for (std::size_t w = 0; w < ofCells.size(); ++w) {
    const HeldBy64 held = heldBy64(from - PaddedCells::kBelow + w * kWord);
    bits[w] = held.some & ofCells[w];
    bits[ofCells.size() + w] = held.full & ofCells[w];
  }
}

// Copies the rows of a plane, `across` cells and `row` words apart, the first at `to`. Rows so near
// the ends of `all` that reads would leave it are copied to a buffer first.
template <typename Cell>
void layRows(std::span<const Cell> all, std::size_t first, std::size_t width, std::size_t rows,
             std::span<const std::uint64_t> ofCells, std::size_t across, std::size_t row, Cell* to,
             std::uint64_t* bits) {
  constexpr std::size_t kBelow = PaddedCells::kBelow;
  const std::size_t read = std::max(ofCells.size() * kWord, kBelow + width + kStep);
  std::vector<Cell> apart(kBelow + read);
  for (std::size_t y = 0; y < rows; ++y, first += width, to += across, bits += row) {
    const Cell* from = all.data() + first;
    if (first < kBelow || first + read > all.size()) [[unlikely]] {
      std::copy_n(from, width, apart.begin() + kBelow);
      from = apart.data() + kBelow;
    }
    layRow(from, width, ofCells, to, bits);
  }
}

// Copies all cells and finds their occupancy masks.
template <typename Cell>
ColourValues padded(std::span<const Cell> cells, const Vec3i& dims, const Vec3i& paddedDims,
                    HeldBits& held) {
  constexpr std::size_t kFirst = PaddedCells::kBelow;
  const auto width = std::size_t(dims.x()), rows = std::size_t(dims.y());
  const auto across = std::size_t(paddedDims.x()), down = std::size_t(paddedDims.y());
  const std::size_t count = across * down * std::size_t(paddedDims.z());
  RawArray<Cell> all;
  growTo(all, count + kBehind);
  std::fill_n(all.begin() + std::ptrdiff_t(count), kBehind, Cell(0));
  const std::vector<std::uint64_t> ofCells = bitsOfCells(width, held.words);
  parallelFor(std::size_t(paddedDims.z()), kPlanes, [&](std::size_t begin, std::size_t end) {
    for (std::size_t plane = begin; plane < end; ++plane) {
      Cell* to = all.data() + plane * down * across;
      Cell* const last = to + down * across;
      std::uint64_t* bits = held.bits.data() + plane * down * held.row;
      std::fill_n(bits, down * held.row, 0);
      if (plane >= kFirst && plane < kFirst + std::size_t(dims.z())) {
        to = std::fill_n(to, kFirst * across + kFirst, Cell(0));
        layRows(cells, (plane - kFirst) * width * rows, width, rows, ofCells, across, held.row, to,
                bits + kFirst * held.row);
        to += rows * across;
      }
      std::fill(to, last, Cell(0));
    }
  });
  return ColourValues(std::move(all));
}

template <typename Cell>
PaddedCells::Held heldBy(const Cell* first, const Vec3i& dims, std::ptrdiff_t alongY,
                         std::ptrdiff_t alongZ, Cell all) {
  if (*first != 0 && *first != all) return PaddedCells::Held::Mixed;
  for (int z = 0; z < dims.z(); ++z)
    for (int y = 0; y < dims.y(); ++y) {
      const Cell* row = first + z * alongZ + y * alongY;
      for (int x = 0; x < dims.x(); ++x)
        if (row[x] != *first) return PaddedCells::Held::Mixed;
    }
  return *first == 0 ? PaddedCells::Held::Nothing : PaddedCells::Held::All;
}

}  // namespace

PaddedCells::PaddedCells(const Discretization& cells, HeldBits& held)
    : dims_(cells.lattice.dims + Vec3i::Constant(int(kAdded))) {
  held = HeldBits(std::size_t(dims_.y()) * std::size_t(dims_.z()), std::size_t(dims_.x()));
  const ColourValues& values = cells.value;
  values_ = values.areLevels() ? padded(values.levels(), cells.lattice.dims, dims_, held)
                               : padded(values.numbers(), cells.lattice.dims, dims_, held);
}

PaddedCells::Held PaddedCells::heldIn(const Vec3i& low, const Vec3i& dims) const {
  const std::ptrdiff_t alongY = dims_.x(), alongZ = alongY * dims_.y();
  const auto at = index(low);
  return values_.areLevels()
             ? heldBy(values_.levels().data() + at, dims, alongY, alongZ, kFullLevel)
             : heldBy(values_.numbers().data() + at, dims, alongY, alongZ, 100.f);
}

}  // namespace resect
