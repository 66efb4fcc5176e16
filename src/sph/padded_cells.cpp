#include "sph/padded_cells.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <span>
#include <vector>

#include "base/flag_bits.h"
#include "base/growth.h"
#include "base/instruction_set.h"
#include "base/parallel.h"

namespace resect {
namespace {

constexpr std::size_t kGrain = 4;    // planes that one thread takes
constexpr std::size_t kStep = 32;    // bytes that are copied at once
constexpr std::size_t kBehind = 16;  // cells after the last one that may be read
constexpr std::size_t kAdded = PaddedCells::kBelow + PaddedCells::kAbove;

// A plane of cells, without those that are added: as they will be kept, one after the other, and
// what they hold. Cells are told in one go, not row by row: rows of small organs are short.
template <typename Cell>
struct ToldPlane {
  RawArray<Cell> cells;
  // One word before the first cell's and some behind, so that a row with the added cells may be
  // read.
  std::vector<std::uint64_t> some, full;

  ToldPlane(std::size_t area, std::size_t wordsOfRow)
      : cells(area + HeldBits::kWord),
        some(area / HeldBits::kWord + wordsOfRow + 3),
        full(some.size()) {}
};

bool tell(const float* from, std::size_t count, ToldPlane<std::uint8_t>& told) {
  return toLevels(from, count, told.cells.data(), told.some.data() + 1, told.full.data() + 1);
}

bool tell(const float* from, std::size_t count, ToldPlane<float>& told) {
  std::copy_n(from, count, told.cells.begin());
  std::fill_n(told.cells.begin() + std::ptrdiff_t(count), HeldBits::kWord, 0.f);
  for (std::size_t i = 0; i < count; i += HeldBits::kWord) {
    const float* of = told.cells.data() + i;
    const std::size_t word = 1 + i / HeldBits::kWord;
    told.some[word] = compared64(of, [](const FourValues& v) -> FourFlags { return v != 0.f; });
    told.full[word] = compared64(of, [](const FourValues& v) -> FourFlags { return v == 100.f; });
  }
  return true;
}

// The words of a row of `count` cells and of the added ones, with the bits of the former set.
RawArray<std::uint64_t> bitsOfCells(std::size_t count, std::size_t words) {
  RawArray<std::uint64_t> bits(words, 0);
  for (std::size_t i = PaddedCells::kBelow; i < PaddedCells::kBelow + count; ++i)
    bits[i / HeldBits::kWord] |= std::uint64_t(1) << i % HeldBits::kWord;
  return bits;
}

// Lays out a plane's rows of `width` cells and of their bits, `across` cells and `row` words apart.
// The added cells behind each row and before the next one become empty; up to kStep bytes more may
// be written. ofCells: bitsOfCells(). Aims at 40 instructions a short row.
template <typename Cell>
[[gnu::always_inline]] inline void layRows(const ToldPlane<Cell>& told, std::size_t width,
                                           std::size_t rows, std::span<const std::uint64_t> ofCells,
                                           std::size_t across, std::size_t row, Cell* to,
                                           std::uint64_t* bits) {
  const Cell* from = told.cells.data();
  std::size_t start = HeldBits::kWord - PaddedCells::kBelow;  // bit of the first added cell
  for (std::size_t y = 0; y < rows; ++y) {
    for (std::size_t i = 0; i < width; i += kStep / sizeof(Cell))
      std::memcpy(to + i, from + i, kStep);
    std::memset(to + width, 0, kAdded * sizeof(Cell));
    for (std::size_t w = 0; w < ofCells.size(); ++w) {
      const std::size_t word = start / HeldBits::kWord + w, shift = start % HeldBits::kWord;
      const auto from64 = [&](const std::vector<std::uint64_t>& words) {
        return words[word] >> shift | words[word + 1] << 1 << (HeldBits::kWord - 1 - shift);
      };
      bits[w] = from64(told.some) & ofCells[w];
      bits[ofCells.size() + w] = from64(told.full) & ofCells[w];
    }
    from += width;
    start += width;
    to += across;
    bits += row;
  }
}
RESECT_WIDEST
void layPlane(const ToldPlane<std::uint8_t>& told, std::size_t width, std::size_t rows,
              std::span<const std::uint64_t> ofCells, std::size_t across, std::size_t row,
              std::uint8_t* to, std::uint64_t* bits) {
  layRows(told, width, rows, ofCells, across, row, to, bits);
}
RESECT_WIDEST
void layPlane(const ToldPlane<float>& told, std::size_t width, std::size_t rows,
              std::span<const std::uint64_t> ofCells, std::size_t across, std::size_t row,
              float* to, std::uint64_t* bits) {
  layRows(told, width, rows, ofCells, across, row, to, bits);
}

// Copies all cells and finds what they hold. False if they cannot be kept so.
template <typename Cell>
bool copyCells(const Discretization& cells, const Vec3i& paddedDims, HeldBits& held,
               RawArray<Cell>& padded) {
  constexpr std::size_t kFirst = PaddedCells::kBelow;
  const auto width = std::size_t(cells.lattice.dims.x()),
             rows = std::size_t(cells.lattice.dims.y()), area = width * rows;
  const auto across = std::size_t(paddedDims.x()), down = std::size_t(paddedDims.y());
  const std::size_t count = across * down * std::size_t(paddedDims.z());
  growTo(padded, count + kBehind);
  std::fill_n(padded.begin() + std::ptrdiff_t(count), kBehind, Cell(0));
  const RawArray<std::uint64_t> ofCells = bitsOfCells(width, held.words);
  std::atomic<bool> kept = true;
  parallelFor(std::size_t(paddedDims.z()), kGrain, [&](std::size_t begin, std::size_t end) {
    ToldPlane<Cell> told(area, held.words);
    for (std::size_t plane = begin; plane < end && kept; ++plane) {
      Cell* to = padded.data() + plane * down * across;
      Cell* const last = to + down * across;
      std::uint64_t* bits = held.bits.data() + plane * down * held.row;
      std::fill_n(bits, down * held.row, 0);
      if (plane >= kFirst && plane < kFirst + std::size_t(cells.lattice.dims.z())) {
        if (!tell(cells.value.data() + (plane - kFirst) * area, area, told)) kept = false;
        to = std::fill_n(to, kFirst * across + kFirst, Cell(0));
        layPlane(told, width, rows, ofCells, across, held.row, to, bits + kFirst * held.row);
        to += rows * across;
      }
      std::fill(to, last, Cell(0));
    }
  });
  return kept;
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
  if (copyCells(cells, dims_, held, levels_)) return;
  levels_ = RawArray<std::uint8_t>();  // {} would keep its memory
  copyCells(cells, dims_, held, numbers_);
}

void PaddedCells::set(std::int64_t at, float value) {
  std::uint8_t level = 0;
  if (byBytes() && !toLevel(value, level)) {
    growTo(numbers_, levels_.size());
    std::transform(levels_.begin(), levels_.end(), numbers_.begin(),
                   [](std::uint8_t number) { return float(number) * kLevel; });
    levels_ = RawArray<std::uint8_t>();
  }
  if (byBytes())
    levels_[std::size_t(at)] = level;
  else
    numbers_[std::size_t(at)] = value;
}

PaddedCells::Held PaddedCells::heldIn(const Vec3i& low, const Vec3i& dims) const {
  const std::ptrdiff_t alongY = dims_.x(), alongZ = alongY * dims_.y();
  const auto at = place(low);
  return byBytes() ? heldBy(levels_.data() + at, dims, alongY, alongZ, kFullLevel)
                   : heldBy(numbers_.data() + at, dims, alongY, alongZ, 100.f);
}

}  // namespace resect
