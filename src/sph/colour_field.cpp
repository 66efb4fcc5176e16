#include "sph/colour_field.h"

#include <algorithm>
#include <cmath>

#include "base/assert.h"
#include "base/parallel.h"
#include "sph/kernel.h"

namespace resect {
namespace {

int floorDiv(int a, int b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

}  // namespace

ColourField::ColourField(const Discretization& cells, int refine)
    : lattice_(cells.lattice), refine_(refine) {
  RESECT_ASSERT(refine >= 1 && refine <= 4);
  RESECT_ASSERT(std::int64_t(cells.value.size()) == lattice_.cellCount());
  // Nodes reach from cell -2 to cell dims + 1: there the kernel of the outermost cell has just
  // vanished.
  for (int a = 0; a < 3; ++a)
    brickDims_[a] = ((lattice_.dims[a] + 3) * refine + kBrickNodes) / kBrickNodes;
  paddedDims_ = lattice_.dims + Vec3i::Constant(2 * kPad);

  cells_.assign(std::size_t(paddedDims_.x()) * paddedDims_.y() * paddedDims_.z(), 0.f);
  for (int z = 0; z < lattice_.dims.z(); ++z)
    for (int y = 0; y < lattice_.dims.y(); ++y)
      std::copy_n(cells.value.begin() + lattice_.index({0, y, z}), lattice_.dims.x(),
                  cells_.begin() + padded({0, y, z}));
  originalCells_ = cells_;

  // A node at position p / refine of its cell reaches the cells nearer than the kernel's support of
  // two cells.
  for (int pz = 0; pz < refine; ++pz)
    for (int py = 0; py < refine; ++py)
      for (int px = 0; px < refine; ++px) {
        std::vector<Tap>& taps = taps_.emplace_back();
        float full = 0;
        for (int dz = -1; dz <= 2; ++dz)
          for (int dy = -1; dy <= 2; ++dy)
            for (int dx = -1; dx <= 2; ++dx) {
              const Vec3 d(dx - double(px) / refine, dy - double(py) / refine,
                           dz - double(pz) / refine);
              const double w = kernel(d.norm(), kSmoothingPerSpacing);
              if (w <= 0) continue;
              taps.push_back({((dz + 1) * kWindow + dy + 1) * kWindow + dx + 1, float(w)});
              full += 100.f * float(w);
            }
        fullValues_.push_back(full);
      }

  slotOf_.assign(std::size_t(brickCount()), kEmpty);
  edited_.assign(std::size_t(brickCount()), 0);
  parallelFor(slotOf_.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      const Reach r = reach(brick(std::int64_t(b)));
      slotOf_[b] = r == Reach::Empty ? kEmpty : r == Reach::Full ? kFull : 0;
    }
  });
  std::vector<std::int64_t> stored;
  for (std::size_t b = 0; b < slotOf_.size(); ++b)
    if (slotOf_[b] == 0) {
      slotOf_[b] = std::int32_t(stored.size());
      stored.push_back(std::int64_t(b));
    }
  values_.resize(stored.size() * kBrickSize);
  parallelFor(stored.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      evaluate(brick(stored[i]), values_.data() + i * kBrickSize);
  });
}

// The lowest cell that the brick's nodes reach.
Vec3i ColourField::windowCell(const Vec3i& b) const {
  return {kBrickNodes * b.x() / refine_ - 3, kBrickNodes * b.y() / refine_ - 3,
          kBrickNodes * b.z() / refine_ - 3};
}

// Looks at the cells that the brick's nodes and the plane of nodes after them reach.
ColourField::Reach ColourField::reach(const Vec3i& b) const {
  const Vec3i low = windowCell(b);
  Vec3i
      high;  // the last node's cell, two on, but the kernel has vanished on a cell two away exactly
  for (int a = 0; a < 3; ++a) {
    const int last = kBrickNodes * b[a] + kBrickNodes;
    high[a] = last / refine_ - 2 + (last % refine_ == 0 ? 1 : 2);
  }
  const float first = cells_[padded(low)];
  if (first != 0.f && first != 100.f) return Reach::Mixed;
  for (int z = low.z(); z <= high.z(); ++z)
    for (int y = low.y(); y <= high.y(); ++y) {
      const float* row = cells_.data() + padded({low.x(), y, z});
      for (int x = 0; x <= high.x() - low.x(); ++x)
        if (row[x] != first) return Reach::Mixed;
    }
  return first == 0.f ? Reach::Empty : Reach::Full;
}

// 64 nodes x at most 36 taps; the window of cells is gathered once so that the taps are plain
// offsets.
void ColourField::evaluate(const Vec3i& b, float* out) const {
  const Vec3i low = windowCell(b);
  float window[kWindow * kWindow * kWindow];
  for (int z = 0; z < kWindow; ++z)
    for (int y = 0; y < kWindow; ++y)
      std::copy_n(cells_.data() + padded(low + Vec3i(0, y, z)), kWindow,
                  window + (z * kWindow + y) * kWindow);

  // Per axis and node of the brick: its position in its cell, and that cell's place in the window
  // (less one: taps start there).
  int position[3][kBrickNodes], place[3][kBrickNodes];
  for (int a = 0; a < 3; ++a)
    for (int i = 0; i < kBrickNodes; ++i) {
      const int node = kBrickNodes * b[a] + i;
      position[a][i] = node % refine_;
      place[a][i] = node / refine_ - 2 - 1 - low[a];
    }
  for (int z = 0; z < kBrickNodes; ++z)
    for (int y = 0; y < kBrickNodes; ++y)
      for (int x = 0; x < kBrickNodes; ++x) {
        const auto& taps =
            taps_[(position[2][z] * refine_ + position[1][y]) * refine_ + position[0][x]];
        const float* base = window + (place[2][z] * kWindow + place[1][y]) * kWindow + place[0][x];
        float sum = 0;
        for (const Tap& tap : taps) sum += base[tap.offset] * tap.weight;
        *out++ = sum;
      }
}

float ColourField::node(const Vec3i& n) const {
  if ((n.array() < 0).any() || (n.array() >= nodeDims().array()).any()) return 0;
  const std::int32_t s = slot(brickIndex(n / kBrickNodes));
  if (s == kEmpty) return 0;
  if (s == kFull)
    return fullValues_[(n.z() % refine_ * refine_ + n.y() % refine_) * refine_ + n.x() % refine_];
  return values(s)[(n.z() % 4 * 4 + n.y() % 4) * 4 + n.x() % 4];
}

void ColourField::setCellValue(std::int64_t cell, float value) {
  const Vec3i c = lattice_.cell(cell);
  float& stored = cells_[padded(c)];
  if (stored == value) return;
  stored = value;
  // Nodes within two cells change; a vertex lies up to one node below them, and its normal reads
  // one node further both ways.
  Vec3i low, high;
  for (int a = 0; a < 3; ++a) {
    const int middle = refine_ * (c[a] + 2);
    low[a] = std::max(0, floorDiv(middle - 2 * refine_ - 1, kBrickNodes));
    high[a] = std::min(brickDims_[a] - 1, floorDiv(middle + 2 * refine_, kBrickNodes));
  }
  for (int z = low.z(); z <= high.z(); ++z)
    for (int y = low.y(); y <= high.y(); ++y)
      for (int x = low.x(); x <= high.x(); ++x) pending_.push_back(brickIndex({x, y, z}));
}

std::int32_t ColourField::takeSlot() {
  if (freeSlots_.empty()) {
    values_.resize(values_.size() + kBrickSize);
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
  touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
  for (const std::int64_t b : touched_) {
    edited_[b] = 1;
    const Reach r = reach(brick(b));
    std::int32_t& s = slotOf_[b];
    if (r == Reach::Mixed) {
      if (s < 0) s = takeSlot();
    } else {
      if (s >= 0) freeSlots_.push_back(s);
      s = r == Reach::Empty ? kEmpty : kFull;
    }
  }
  parallelFor(touched_.size(), 32, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::int32_t s = slotOf_[touched_[i]];
      if (s >= 0) evaluate(brick(touched_[i]), values_.data() + std::size_t(s) * kBrickSize);
    }
  });
  return touched_;
}

float ColourField::originalNode(const Vec3i& n) const {
  const auto& taps =
      taps_[(n.z() % refine_ * refine_ + n.y() % refine_) * refine_ + n.x() % refine_];
  const Vec3i low = n / refine_ - Vec3i::Constant(3);
  float sum = 0;
  for (const Tap& tap : taps) {
    const Vec3i d(tap.offset % kWindow, tap.offset / kWindow % kWindow,
                  tap.offset / (kWindow * kWindow));
    sum += originalCells_[padded(low + d)] * tap.weight;
  }
  return sum;
}

std::size_t ColourField::bytes() const {
  return (cells_.capacity() + originalCells_.capacity() + values_.capacity()) * sizeof(float) +
         slotOf_.capacity() * sizeof(std::int32_t) + edited_.capacity();
}

}  // namespace resect
