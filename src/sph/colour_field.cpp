#include "sph/colour_field.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "base/assert.h"
#include "base/flag_bits.h"
#include "base/growth.h"
#include "base/instruction_set.h"
#include "base/parallel.h"

namespace resect {
namespace {

constexpr unsigned kAllPlanes = 0xf, kPending = 0x10;  // bits of a brick that waits for update()
constexpr int kMostBricks = 6;         // that a cell reaches along an axis: 17 nodes at refine 4
constexpr std::size_t kGrain = 128;    // bricks that one thread takes: some 50 us
constexpr std::size_t kRowGrain = 16;  // the same of rows of bricks, few of which are stored

// What each cell of the padded lattice holds, as bits: anything at all, and all it can? Row after
// row; of each first the words of the one, then those of the other. Cells that are not there hold
// nothing: zeros.
struct HeldBits {
  static constexpr std::size_t kWord = 64, kChunk = 4;  // cells; words that are combined at once
  std::size_t words, row;                               // of either kind, and of both, rounded up
  RawArray<std::uint64_t> bits;

  HeldBits(std::size_t rows, std::size_t cells)
      : words((cells + kWord - 1) / kWord),
        row((2 * words + kChunk - 1) / kChunk * kChunk),
        bits(rows * row) {}
};

constexpr std::size_t kCopied = 16;  // cells that are copied at once

// Copies sixteen and says what they hold. False if they cannot be kept so.
[[gnu::always_inline]] inline bool copy16(const float* from, float* to, std::uint64_t& some,
                                          std::uint64_t& full) {
  some = compared16(from, [](const FourValues& v) -> FourFlags { return v != 0.f; });
  full = compared16(from, [](const FourValues& v) -> FourFlags { return v == 100.f; });
  std::memcpy(to, from, kCopied * sizeof(float));
  return true;
}
[[gnu::always_inline]] inline bool copy16(const float* from, std::uint8_t* to, std::uint64_t& some,
                                          std::uint64_t& full) {
  return inLevels(from, to, some, full);
}

// Copies a row of cells and finds what they hold, bits: 0 until now; first: of the row's cells
// among the bits. Up to kCopied - 1 cells more may be written. False if they cannot be kept so.
template <typename Cell>
[[gnu::always_inline]] inline bool copyCells(const float* from, std::size_t count, Cell* to,
                                             std::size_t first, std::size_t words,
                                             std::uint64_t* bits) {
  float few[kCopied] = {};
  if (count < kCopied) {
    std::copy_n(from, count, few);
    from = few;
    count = kCopied;
  }
  bool kept = true;
  for (std::size_t done = 0; done < count; done += kCopied) {
    const std::size_t i = std::min(done, count - kCopied);  // the last ones, some of them again
    std::uint64_t some, full;
    kept &= copy16(from + i, to + i, some, full);
    const std::size_t word = (first + i) / 64, shift = (first + i) % 64;
    bits[word] |= some << shift;
    bits[words + word] |= full << shift;
    if (shift <= 64 - kCopied) continue;
    bits[word + 1] |= some >> (64 - shift);
    bits[words + word + 1] |= full >> (64 - shift);
  }
  return kept;
}
RESECT_WIDEST
bool copyRow(const float* from, std::size_t count, float* to, std::size_t first, std::size_t words,
             std::uint64_t* bits) {
  return copyCells(from, count, to, first, words, bits);
}
RESECT_WIDEST
bool copyRow(const float* from, std::size_t count, std::uint8_t* to, std::size_t first,
             std::size_t words, std::uint64_t* bits) {
  return copyCells(from, count, to, first, words, bits);
}

// Copies all cells, padded by `below` and more above, and finds what they hold. False if they
// cannot be kept so.
template <typename Cell>
bool copyPadded(const Discretization& cells, const Vec3i& paddedDims, int below, HeldBits& held,
                RawArray<Cell>& padded) {
  const Vec3i dims = cells.lattice.dims;
  const auto across = std::size_t(paddedDims.x()), down = std::size_t(paddedDims.y());
  const auto before = std::size_t(below), after = across - before - std::size_t(dims.x());
  growTo(padded, across * down * std::size_t(paddedDims.z()));
  std::atomic<bool> kept = true;
  parallelFor(std::size_t(paddedDims.z()), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t plane = begin; plane < end; ++plane) {
      const int z = int(plane) - below;
      Cell* to = padded.data() + plane * down * across;
      Cell* const last = to + down * across;
      std::uint64_t* bits = held.bits.data() + plane * down * held.row;
      std::fill_n(bits, down * held.row, 0);
      if (z >= 0 && z < dims.z()) {
        bits += before * held.row;
        // Up to the first cell, behind each row as far as the next one's first, behind the last.
        to = std::fill_n(to, before * across + before, Cell(0));
        for (int y = 0; y < dims.y(); ++y, bits += held.row) {
          if (!copyRow(cells.value.data() + cells.lattice.index({0, y, z}), std::size_t(dims.x()),
                       to, before, held.words, bits))
            kept = false;
          to = std::fill_n(to + dims.x(), after + before, Cell(0));
        }
      }
      std::fill(to, last, Cell(0));
    }
  });
  return kept;
}

// What a box of rows holds together, rows x planes of them from `first` on: anything, and less than
// all it can? nothing: the words that say so of no cells.
RESECT_WIDEST
void holdOfRows(const HeldBits& held, std::size_t first, int rows, int planes, std::size_t perPlane,
                const std::uint64_t* nothing, std::uint64_t* bits) {
  for (std::size_t chunk = 0; chunk < held.row; chunk += HeldBits::kChunk) {
    std::uint64_t any[HeldBits::kChunk] = {};
    for (int z = 0; z < planes; ++z) {
      const std::uint64_t* row =
          held.bits.data() + (first + std::size_t(z) * perPlane) * held.row + chunk;
      for (int y = 0; y < rows; ++y, row += held.row)
        for (std::size_t k = 0; k < HeldBits::kChunk; ++k) any[k] |= row[k] ^ nothing[chunk + k];
    }
    std::memcpy(bits + chunk, any, sizeof any);
  }
}

// From each cell of a row on: what `width` cells hold.
void holdAlong(std::size_t words, int width, std::uint64_t* bits) {
  for (std::size_t w = 0; w < words; ++w) {
    const std::uint64_t here = bits[w], next = w + 1 < words ? bits[w + 1] : 0;
    for (int k = 1; k < width; ++k) bits[w] |= here >> k | next << (64 - k);
  }
}

int floorDiv(int a, int b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

}  // namespace

ColourField::ColourField(const Discretization& cells, int refine)
    : lattice_(cells.lattice), refine_(refine), stencil_(&fieldStencil(refine)) {
  RESECT_ASSERT(std::int64_t(cells.value.size()) == lattice_.cellCount());
  // Nodes reach from cell -2 to cell dims + 1: there the kernel of the outermost cell has just
  // vanished.
  for (int a = 0; a < 3; ++a)
    brickDims_[a] = ((lattice_.dims[a] + 3) * refine + kBrickNodes) / kBrickNodes;
  paddedDims_ = lattice_.dims + Vec3i::Constant(kPadBelow + kPadAbove);

  slotOf_.assign(std::size_t(brickCount()), kEmpty);
  originalOf_.assign(slotOf_.size(), kUnedited);
  pendingOf_.assign(slotOf_.size(), 0);
  classifyBricks(cells);
  std::int32_t count = 0;
  for (std::int32_t& slot : slotOf_) {
    const bool mixed = slot == 0;
    slot = mixed ? count : slot;
    count += mixed;
  }
  putFullAndEmpty(originals_);
  growTo(values_, place(count));
  putFullAndEmpty(values_);
  // Row by row of bricks.
  const auto brickRows = std::size_t(brickDims_.y()) * std::size_t(brickDims_.z());
  parallelFor(brickRows, kRowGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      Vec3i b(0, int(row % std::size_t(brickDims_.y())), int(row / std::size_t(brickDims_.y())));
      const std::int32_t* slot = slotOf_.data() + brickIndex(b);
      for (; b.x() < brickDims_.x(); ++b.x())
        if (slot[b.x()] >= 0) evaluate(b, kAllPlanes, values_.data() + place(slot[b.x()]));
    }
  });
}

void ColourField::putFullAndEmpty(RawArray<float>& bricks) const {
  bricks.resize(std::max(bricks.size(), place(0)));
  std::copy_n(stencil_->full.begin(), kBrickSize, bricks.begin() + std::ptrdiff_t(place(kFull)));
  std::fill_n(bricks.begin() + std::ptrdiff_t(place(kEmpty)), kBrickSize, 0.f);
}

const float* ColourField::nodesByPhase(std::int64_t b, std::int32_t slot,
                                       const RawArray<float>& bricks) const {
  return slot == kFull ? stencil_->full.data() + stencil_->phaseIndex(phase(brick(b))) * kBrickSize
                       : bricks.data() + place(slot);
}

void ColourField::evaluate(const Vec3i& b, unsigned planes, float* out) const {
  const std::ptrdiff_t alongY = paddedDims_.x(), alongZ = alongY * paddedDims_.y();
  const std::int64_t low = padded(windowCell(b));
  if (byBytes())
    sumBrick(*stencil_, phase(b), levels_.data() + low, alongY, alongZ, planes, out);
  else
    sumBrick(*stencil_, phase(b), cells_.data() + low, alongY, alongZ, planes, out);
}

// The lowest cell that the brick's nodes reach.
Vec3i ColourField::windowCell(const Vec3i& b) const {
  return {cellOf(kBrickNodes * b.x()) - 3, cellOf(kBrickNodes * b.y()) - 3,
          cellOf(kBrickNodes * b.z()) - 3};
}

// The highest cell that the nodes of brick b and the plane of nodes after them reach along an axis:
// two on from the last node's cell, but the kernel has just vanished on a cell exactly two away.
int ColourField::highestCell(int b) const {
  const int last = kBrickNodes * (b + 1);
  return last / refine_ - 2 + (last % refine_ == 0 ? 1 : 2);
}

ColourField::Reach ColourField::reach(const Vec3i& b) const {
  const Vec3i low = windowCell(b);
  const int width = highestCell(b.x()) - low.x() + 1;
  const auto among = [&](const auto& cells, auto all) {
    const auto first = cells[padded(low)];
    if (first != 0 && first != all) return Reach::Mixed;
    for (int z = low.z(); z <= highestCell(b.z()); ++z)
      for (int y = low.y(); y <= highestCell(b.y()); ++y) {
        const auto* row = cells.data() + padded({low.x(), y, z});
        for (int x = 0; x < width; ++x)
          if (row[x] != first) return Reach::Mixed;
      }
    return first == 0 ? Reach::Empty : Reach::Full;
  };
  return byBytes() ? among(levels_, kFullLevel) : among(cells_, 100.f);
}

// Copies the cells and finds reach() of every brick, into slotOf_. What the cells of a row hold
// becomes two bits a cell; the rows that a row of bricks reaches are combined as words, 64 cells at
// a time. Aims at one pass over the cells.
void ColourField::classifyBricks(const Discretization& cells) {
  const std::size_t across = std::size_t(paddedDims_.x()), down = std::size_t(paddedDims_.y());
  const auto rowOf = [&](int y, int z) {
    return std::size_t(z + kPadBelow) * down + std::size_t(y + kPadBelow);
  };
  HeldBits held(down * std::size_t(paddedDims_.z()), across);
  if (!copyPadded(cells, paddedDims_, kPadBelow, held, levels_)) {
    levels_ = {};
    copyPadded(cells, paddedDims_, kPadBelow, held, cells_);
  }
  std::vector<std::uint64_t> nothing(held.row, 0);
  std::fill_n(nothing.begin() + std::ptrdiff_t(held.words), held.words, ~std::uint64_t(0));
  const int width = highestCell(0) - windowCell(Vec3i::Zero()).x() + 1;  // the same for all bricks
  parallelFor(
      std::size_t(brickDims_.y()) * brickDims_.z(), 64, [&](std::size_t begin, std::size_t end) {
        std::vector<std::uint64_t> bits(held.row);
        for (std::size_t i = begin; i < end; ++i) {
          const Vec3i b(0, int(i) % brickDims_.y(), int(i) / brickDims_.y()), low = windowCell(b);
          holdOfRows(held, rowOf(low.y(), low.z()), highestCell(b.y()) - low.y() + 1,
                     highestCell(b.z()) - low.z() + 1, down, nothing.data(), bits.data());
          const std::uint64_t *some = bits.data(), *less = some + held.words;
          holdAlong(held.words, width, bits.data());
          holdAlong(held.words, width, bits.data() + held.words);
          std::int32_t* slot = slotOf_.data() + brickIndex(b);
          for (int x = 0; x < brickDims_.x(); ++x) {
            const auto bit = unsigned(cellOf(kBrickNodes * x));  // of the padded row
            slot[x] = !(some[bit / 64] >> bit % 64 & 1)   ? kEmpty
                      : !(less[bit / 64] >> bit % 64 & 1) ? kFull
                                                          : 0;
          }
        }
      });
}

IndexBox ColourField::bricksIn(const Aabb& box) const {
  const Vec3 origin = nodePosition(Vec3::Zero());
  const Vec3 side = lattice_.spacing * (double(kBrickNodes) / refine_);
  const Vec3 last = (brickDims_ - Vec3i::Ones()).cast<double>();
  const auto brickAt = [&](const Vec3& p) {
    return Vec3((p - origin).cwiseQuotient(side).array().floor().matrix());
  };
  const Vec3i low = brickAt(box.min).cwiseMax(0).cwiseMin(last + Vec3::Ones()).cast<int>();
  const Vec3i high = brickAt(box.max).cwiseMin(last).cwiseMax(-1).cast<int>();
  return {low, (high - low + Vec3i::Ones()).cwiseMax(0)};
}

float ColourField::node(const Vec3i& n) const {
  if ((n.array() < 0).any() || (n.array() >= nodeDims().array()).any()) return 0;
  return nodes(n / kBrickNodes)[(n.z() % 4 * 4 + n.y() % 4) * 4 + n.x() % 4];
}

float ColourField::originalNode(const Vec3i& n) const {
  return originalNodes(n / kBrickNodes)[(n.z() % 4 * 4 + n.y() % 4) * 4 + n.x() % 4];
}

void ColourField::setCellValue(std::int64_t cell, float value) {
  const Vec3i c = lattice_.cell(cell);
  if (cellValue(cell) == value) return;
  std::uint8_t number = 0;
  if (byBytes() && !inLevels(value, number)) {
    growTo(cells_, levels_.size());
    std::transform(levels_.begin(), levels_.end(), cells_.begin(),
                   [](std::uint8_t held) { return float(held) * kLevel; });
    levels_ = {};
  }
  if (byBytes())
    levels_[padded(c)] = number;
  else
    cells_[padded(c)] = value;
  // Nodes nearer than two cells change; a vertex lies up to one node below them, and its normal
  // reads one node further both ways.
  const int reach = 2 * refine_;
  const Vec3i middle = refine_ * (c + Vec3i::Constant(2));
  Vec3i low, high;
  unsigned changed[3][kMostBricks];  // which nodes of each brick along an axis, as bits
  for (int a = 0; a < 3; ++a) {
    low[a] = std::max(0, floorDiv(middle[a] - reach - 1, kBrickNodes));
    high[a] = std::min(brickDims_[a] - 1, floorDiv(middle[a] + reach, kBrickNodes));
    for (int b = low[a]; b <= high[a]; ++b) {
      unsigned& bits = changed[a][b - low[a]] = 0;
      for (int i = 0; i < kBrickNodes; ++i)
        bits |= unsigned(std::abs(kBrickNodes * b + i - middle[a]) < reach) << i;
    }
  }
  for (int z = low.z(); z <= high.z(); ++z)
    for (int y = low.y(); y <= high.y(); ++y) {
      const unsigned planes = changed[1][y - low.y()] != 0 ? changed[2][z - low.z()] : 0;
      const std::int64_t row = brickIndex({0, y, z});
      for (int x = low.x(); x <= high.x(); ++x) {
        std::uint8_t& pending = pendingOf_[row + x];
        if (pending == 0) pending_.push_back(row + x);
        pending |= std::uint8_t(kPending | (changed[0][x - low.x()] != 0 ? planes : 0));
      }
    }
}

std::int32_t ColourField::takeSlot() {
  if (freeSlots_.empty()) {
    growTo(values_, values_.size() + kBrickSize);
    return slotCount() - 1;
  }
  const std::int32_t s = freeSlots_.back();
  freeSlots_.pop_back();
  return s;
}

std::span<const std::int64_t> ColourField::update() {
  touched_.swap(pending_);
  pending_.clear();
  std::sort(touched_.begin(), touched_.end());
  for (const std::int64_t b : touched_) {
    std::int32_t& s = slotOf_[b];
    if (!edited(b)) {
      originalOf_[b] = s < 0 ? s : slotsOf(originals_);
      if (s >= 0) originals_.insert(originals_.end(), values(s).begin(), values(s).end());
    }
    const Reach r = reach(brick(b));
    if (r == Reach::Mixed) {
      if (s < 0) {
        s = takeSlot();
        pendingOf_[b] |= kAllPlanes;
      }
    } else {
      if (s >= 0) freeSlots_.push_back(s);
      s = r == Reach::Empty ? kEmpty : kFull;
    }
  }
  parallelFor(touched_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::int64_t b = touched_[i];
      const unsigned planes = pendingOf_[b] & kAllPlanes;
      pendingOf_[b] = 0;
      if (slotOf_[b] >= 0 && planes != 0)
        evaluate(brick(b), planes, values_.data() + place(slotOf_[b]));
    }
  });
  return touched_;
}

std::size_t ColourField::bytes() const {
  return levels_.capacity() +
         (cells_.capacity() + values_.capacity() + originals_.capacity()) * sizeof(float) +
         (slotOf_.capacity() + originalOf_.capacity()) * sizeof(std::int32_t) +
         pendingOf_.capacity();
}

}  // namespace resect
