#include "sph/colour_field.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "base/assert.h"
#include "base/growth.h"
#include "base/instruction_set.h"
#include "base/parallel.h"

namespace resect {
namespace {

constexpr unsigned kAllPlanes = 0xf, kPending = 0x10;  // bits of a brick that waits for update()
constexpr int kMostBricks = 6;       // that a cell reaches along an axis: 17 nodes at refine 4
constexpr std::size_t kGrain = 128;  // bricks that one thread takes: some 50 us

void andWith(const std::uint8_t* other, std::size_t count, std::uint8_t* bytes) {
  for (std::size_t i = 0; i < count; ++i) bytes[i] &= other[i];
}

constexpr std::uint8_t kHoldsNone = 1, kHoldsAll = 2;  // what cells hold, as bits

// For each cell of a row: what do the `width` cells from it on all hold? work: count + width + 32
// bytes.
RESECT_WIDEST
void holdAlong(const float* cell, std::size_t count, int width, std::uint8_t* work,
               std::uint8_t* held) {
  for (std::size_t x = 0; x < count; ++x)
    work[x] = std::uint8_t((cell[x] == 0.f ? kHoldsNone : 0) | (cell[x] == 100.f ? kHoldsAll : 0));
  typedef std::uint8_t Bytes __attribute__((vector_size(32)));
  for (std::size_t x = 0; x < count; x += sizeof(Bytes)) {
    Bytes all, other;
    std::memcpy(&all, work + x, sizeof all);
    for (int k = 1; k < width; ++k) {
      std::memcpy(&other, work + x + k, sizeof other);
      all &= other;
    }
    std::memcpy(held + x, &all, std::min(sizeof all, count - x));
  }
}

int floorDiv(int a, int b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

}  // namespace

ColourField::ColourField(const Discretization& cells, int refine)
    : lattice_(cells.lattice), refine_(refine), phases_(refine == 3 ? 3 : 1) {
  RESECT_ASSERT(refine >= 1 && refine <= 4);
  RESECT_ASSERT(std::int64_t(cells.value.size()) == lattice_.cellCount());
  // Nodes reach from cell -2 to cell dims + 1: there the kernel of the outermost cell has just
  // vanished.
  for (int a = 0; a < 3; ++a)
    brickDims_[a] = ((lattice_.dims[a] + 3) * refine + kBrickNodes) / kBrickNodes;
  paddedDims_ = lattice_.dims + Vec3i::Constant(2 * kPad);

  // Row after row between zeros, so that each is written once.
  const std::size_t cellCount = std::size_t(paddedDims_.x()) * paddedDims_.y() * paddedDims_.z();
  reserveFor(cells_, cellCount);
  for (int z = 0; z < lattice_.dims.z(); ++z)
    for (int y = 0; y < lattice_.dims.y(); ++y) {
      cells_.resize(std::size_t(padded({0, y, z})), 0.f);
      const auto row = cells.value.begin() + lattice_.index({0, y, z});
      cells_.insert(cells_.end(), row, row + lattice_.dims.x());
    }
  cells_.resize(cellCount, 0.f);
  makeTaps();

  slotOf_.assign(std::size_t(brickCount()), kEmpty);
  originalOf_.assign(slotOf_.size(), kUnedited);
  pendingOf_.assign(slotOf_.size(), 0);
  classifyBricks();
  std::vector<std::int64_t> stored;
  for (std::size_t b = 0; b < slotOf_.size(); ++b)
    if (slotOf_[b] == 0) {
      slotOf_[b] = std::int32_t(stored.size());
      stored.push_back(std::int64_t(b));
    }
  growTo(values_, stored.size() * kBrickSize, 0.f);
  parallelFor(stored.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      evaluate(brick(stored[i]), kAllPlanes, values_.data() + i * kBrickSize);
  });
}

// The lowest cell that the brick's nodes reach.
Vec3i ColourField::windowCell(const Vec3i& b) const {
  return {kBrickNodes * b.x() / refine_ - 3, kBrickNodes * b.y() / refine_ - 3,
          kBrickNodes * b.z() / refine_ - 3};
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
  const float first = cells_[padded(low)];
  if (first != 0.f && first != 100.f) return Reach::Mixed;
  for (int z = low.z(); z <= highestCell(b.z()); ++z)
    for (int y = low.y(); y <= highestCell(b.y()); ++y) {
      const float* row = cells_.data() + padded({low.x(), y, z});
      for (int x = 0; x < width; ++x)
        if (row[x] != first) return Reach::Mixed;
    }
  return first == 0.f ? Reach::Empty : Reach::Full;
}

// reach() of every brick, into slotOf_. What a row of cells holds from each of its cells on, as far
// as a brick reaches, is found once for all bricks that the row passes; all else is one AND per row
// of bytes. Aims at 10 bytes moved per cell.
void ColourField::classifyBricks() {
  const std::size_t across = std::size_t(paddedDims_.x());
  const int width = highestCell(0) - windowCell(Vec3i::Zero()).x() + 1;  // the same for all bricks
  const auto held = std::make_unique_for_overwrite<std::uint8_t[]>(cells_.size());
  parallelFor(cells_.size() / across, 256, [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint8_t> work(across + std::size_t(width) + 32, 0);
    for (std::size_t row = begin; row < end; ++row)
      holdAlong(cells_.data() + row * across, across, width, work.data(),
                held.get() + row * across);
  });
  parallelFor(
      std::size_t(brickDims_.y()) * brickDims_.z(), 16, [&](std::size_t begin, std::size_t end) {
        std::vector<std::uint8_t> all(across);
        for (std::size_t i = begin; i < end; ++i) {
          const Vec3i b(0, int(i) % brickDims_.y(), int(i) / brickDims_.y()), low = windowCell(b);
          std::fill(all.begin(), all.end(), kHoldsNone | kHoldsAll);
          for (int z = low.z(); z <= highestCell(b.z()); ++z)
            for (int y = low.y(); y <= highestCell(b.y()); ++y)
              andWith(held.get() + padded({-kPad, y, z}), across, all.data());
          std::int32_t* slot = slotOf_.data() + brickIndex(b);
          for (int x = 0; x < brickDims_.x(); ++x) {
            const std::uint8_t holds = all[std::size_t(windowCell({x, 0, 0}).x() + kPad)];
            slot[x] = holds == kHoldsNone ? kEmpty : holds == kHoldsAll ? kFull : 0;
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
  float& stored = cells_[padded(c)];
  if (stored == value) return;
  stored = value;
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
    growTo(values_, values_.size() + kBrickSize, 0.f);
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
      originalOf_[b] = s < 0 ? s : std::int32_t(originals_.size() / kBrickSize);
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
        evaluate(brick(b), planes, values_.data() + std::size_t(slotOf_[b]) * kBrickSize);
    }
  });
  return touched_;
}

std::size_t ColourField::bytes() const {
  return (cells_.capacity() + values_.capacity() + originals_.capacity()) * sizeof(float) +
         (slotOf_.capacity() + originalOf_.capacity()) * sizeof(std::int32_t) +
         pendingOf_.capacity();
}

}  // namespace resect
