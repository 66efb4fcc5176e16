#include "sph/colour_field.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <limits>
#include <numeric>

#include "base/error.h"
#include "base/growth.h"
#include "base/instruction_set.h"
#include "base/parallel.h"

namespace resect {
namespace {

constexpr unsigned kAllPlanes = 0xf, kPending = 0x10;  // bits of a brick that waits for update()
constexpr int kMostBricks = 6;       // in reach of a cell along an axis: 17 nodes at refine 4
constexpr std::size_t kGrain = 128;  // bricks per block of work: some 20 us

int floorDiv(int a, int b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

// Nodes extend from cell -2 to cell cells + 1, where the kernel of the outermost cell is just 0.
int bricksAlong(int cells, int refine) {
  return ((cells + 3) * refine + kBrickNodes) / kBrickNodes;
}

// Compacts a word of cells along x to the bits of cells in which bricks begin: every fourth for one
// node a cell, every second for two, all for four.
std::uint64_t bitsOfBricks(std::uint64_t cells, int refine) {
  constexpr std::uint64_t kFirst = 0x1111111111111111;
  std::uint64_t bits = refine == 2   ? (cells & kFirst) | (cells >> 1 & kFirst << 1)
                       : refine == 1 ? cells & kFirst
                       : refine == 3 ? cells & 7 * kFirst
                                     : cells;
  // Moves the upper of two neighbouring bit fields down.
  const int gap = kBrickNodes - refine;
  constexpr std::uint64_t kLower[] = {0x0f0f0f0f0f0f0f0f, 0x00ff00ff00ff00ff, 0x0000ffff0000ffff,
                                      0x00000000ffffffff};
  for (int k = 0; k < 4; ++k) bits = (bits & kLower[k]) | (bits & ~kLower[k]) >> (gap << k);
  return bits;
}

// Writes kFull for each of `count` bricks whose bit is set, else kEmpty.
RESECT_WIDEST
void markFull(std::uint64_t full, int count, std::int32_t* slots) {
  static_assert(ColourField::kFull == ColourField::kEmpty - 1);
  for (int first = 0; first < count; first += 32) {
    const auto bits = std::uint32_t(full >> first);
    const int here = std::min(32, count - first);
    for (int i = 0; i < here; ++i)
      slots[first + i] = ColourField::kEmpty - std::int32_t(bits >> i & 1);
  }
}

}  // namespace

void requireIso(float iso) {
  require(iso >= kMinIso && iso <= kMaxIso, "iso level is {}; give a value from {} to {}", iso,
          kMinIso, kMaxIso);
}

ColourField::ColourField(const Discretization& cells, int refine)
    : ColourField(cells, refine, NodesLater()) {
  parallelFor(builtBricks_.size(), kGrain,
              [&](std::size_t begin, std::size_t end) { evaluateBuilt(begin, end); });
}

ColourField::ColourField(const Discretization& cells, int refine, NodesLater)
    : lattice_(cells.lattice), refine_(refine), stencil_(&fieldStencil(refine)) {
  require(lattice_.sound() && std::int64_t(cells.value.size()) == lattice_.cellCount(),
          "there are {} colour values in a lattice of {} x {} x {} cells; give one for each",
          cells.value.size(), lattice_.dims.x(), lattice_.dims.y(), lattice_.dims.z());
  require(canHold(lattice_, refine),
          "a lattice of {} x {} x {} cells is too large for {} surface nodes per cell; use fewer",
          lattice_.dims.x(), lattice_.dims.y(), lattice_.dims.z(), refine);
  for (int a = 0; a < 3; ++a) brickDims_[a] = bricksAlong(lattice_.dims[a], refine);
  HeldBits held;
  cells_ = PaddedCells(cells, held);
  classifyBricks(held);
  putFullAndEmpty(originals_);
  growTo(values_, firstNode(std::int32_t(builtBricks_.size())));
  putFullAndEmpty(values_);
}

bool ColourField::canHold(const Lattice& lattice, int refine) {
  double bricks = 1;
  for (int a = 0; a < 3; ++a) bricks *= bricksAlong(lattice.dims[a], refine);
  return bricks < std::numeric_limits<std::int32_t>::max();
}

void ColourField::evaluateBuilt(std::size_t begin, std::size_t end) {
  for (std::size_t slot = begin; slot < end; ++slot)
    evaluate(brick(builtBricks_[slot]), kAllPlanes, values_.data() + firstNode(std::int32_t(slot)));
}

void ColourField::putFullAndEmpty(RawArray<float>& bricks) const {
  bricks.resize(std::max(bricks.size(), firstNode(0)));
  std::copy_n(stencil_->full.begin(), kBrickSize,
              bricks.begin() + std::ptrdiff_t(firstNode(kFull)));
  std::fill_n(bricks.begin() + std::ptrdiff_t(firstNode(kEmpty)), kBrickSize, 0.f);
}

const float* ColourField::nodesByPhase(std::int64_t b, std::int32_t slot,
                                       const RawArray<float>& bricks) const {
  return slot == kFull ? stencil_->full.data() + stencil_->phaseIndex(phase(brick(b))) * kBrickSize
                       : bricks.data() + firstNode(slot);
}

void ColourField::evaluate(const Vec3i& b, unsigned planes, float* out) const {
  const std::ptrdiff_t alongY = cells_.dims().x(), alongZ = alongY * cells_.dims().y();
  cells_.lookAt(cells_.index(windowCell(b)), [&](const auto* low) {
    sumBrick(*stencil_, phase(b), low, alongY, alongZ, planes, out);
  });
}

// The lowest cell in reach of the brick's nodes.
Vec3i ColourField::windowCell(const Vec3i& b) const {
  return {cellOf(kBrickNodes * b.x()) - 3, cellOf(kBrickNodes * b.y()) - 3,
          cellOf(kBrickNodes * b.z()) - 3};
}

// The highest cell in reach, along an axis, of the nodes of brick b and the plane of nodes after
// them: two beyond the last node's cell, or one if the node lies on its cell's centre, since the
// kernel is 0 at two cells.
int ColourField::highestCell(int b) const {
  const int last = kBrickNodes * (b + 1);
  return last / refine_ - 2 + (last % refine_ == 0 ? 1 : 2);
}

// Occupancy of the cells in reach of a brick's nodes and the plane of nodes after them.
PaddedCells::Held ColourField::held(const Vec3i& b) const {
  const Vec3i high(highestCell(b.x()), highestCell(b.y()), highestCell(b.z()));
  return cells_.heldIn(windowCell(b), high - windowCell(b) + Vec3i::Ones());
}

// Finds held() of every brick: slotOf_ and builtBricks_.
void ColourField::classifyBricks(const HeldBits& held) {
  slotOf_.resize(std::size_t(brickCount()));
  const auto across = std::size_t(brickDims_.x()),
             rows = std::size_t(brickDims_.y()) * std::size_t(brickDims_.z());
  RawArray<std::int32_t> mixed(rows * across);  // row by row
  RawArray<std::int32_t> mixedOf(rows);
  parallelFor(rows, 64, [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint64_t> bits(held.row);
    for (std::size_t row = begin; row < end; ++row)
      mixedOf[row] = classifyRow(held, row, bits.data(), mixed.data() + row * across);
  });
  builtBricks_.resize(
      std::size_t(std::accumulate(mixedOf.begin(), mixedOf.end(), std::int64_t(0))));
  std::int32_t slot = 0;
  for (std::size_t row = 0; row < rows; ++row)
    for (std::int32_t i = 0; i < mixedOf[row]; ++i, ++slot) {
      const std::int32_t b = mixed[row * across + std::size_t(i)];
      builtBricks_[std::size_t(slot)] = b;
      slotOf_[std::size_t(b)] = slot;
    }
}

// The same for a row of bricks: the rows of cells in reach are combined as words, 64 cells at a
// time. bits: room for held.row words. Writes the mixed bricks, which have no slots yet, and
// returns their number.
std::int32_t ColourField::classifyRow(const HeldBits& held, std::size_t row, std::uint64_t* bits,
                                      std::int32_t* mixed) {
  const auto down = std::size_t(cells_.dims().y());
  const Vec3i first(0, int(row) % brickDims_.y(), int(row) / brickDims_.y()),
      low = windowCell(first);
  const std::size_t lowest = std::size_t(low.z() + PaddedCells::kBelow) * down +
                             std::size_t(low.y() + PaddedCells::kBelow);
  const int width = highestCell(0) - windowCell(Vec3i::Zero()).x() + 1;  // the same for all bricks
  holdTogether(held, lowest, highestCell(first.y()) - low.y() + 1,
               highestCell(first.z()) - low.z() + 1, down, width, bits);
  const std::uint64_t *some = bits, *less = some + held.words;
  const auto index = std::int32_t(brickIndex(first));
  const int perWord = int(HeldBits::kWord) / kBrickNodes * refine_;
  std::int32_t count = 0;
  for (int x = 0; x < brickDims_.x(); x += perWord, ++some, ++less) {
    const std::uint64_t holds = bitsOfBricks(*some, refine_), lacks = bitsOfBricks(*less, refine_);
    const int here = std::min(perWord, brickDims_.x() - x);
    markFull(holds & ~lacks, here, slotOf_.data() + index + x);
    std::uint64_t both = holds & lacks;
    if (here < int(HeldBits::kWord)) both &= (std::uint64_t(1) << here) - 1;
    for (; both != 0; both &= both - 1) mixed[count++] = index + x + std::countr_zero(both);
  }
  return count;
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
  const std::int64_t at = cells_.index(c);
  if (cells_.value(at) == value) return;
  cells_.set(at, value);
  // Nodes nearer than two cells change; a dependent vertex lies up to one node below them, and its
  // normal reads one node more in either direction.
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
      for (int x = low.x(); x <= high.x(); ++x)
        touch(row + x, changed[0][x - low.x()] != 0 ? planes : 0);
    }
}

// planes: those to be evaluated.
void ColourField::touch(std::int64_t brick, unsigned planes) {
  if (pendingOf_.empty()) pendingOf_.assign(slotOf_.size(), 0);
  std::uint8_t& pending = pendingOf_[std::size_t(brick)];
  if (pending == 0) pending_.push_back(brick);
  pending |= std::uint8_t(kPending | planes);
}

void ColourField::capsChanged(const Vec3i& low, const Vec3i& high) {
  // Vertices and normals depend on nodes as setCellValue() says.
  const Vec3i first = ((low - Vec3i::Constant(2)).cwiseMax(0)) / kBrickNodes,
              last = ((high + Vec3i::Ones()) / kBrickNodes).cwiseMin(brickDims_ - Vec3i::Ones());
  for (int z = first.z(); z <= last.z(); ++z)
    for (int y = first.y(); y <= last.y(); ++y)
      for (int x = first.x(); x <= last.x(); ++x) touch(brickIndex({x, y, z}), kAllPlanes);
}

void ColourField::capsRestored(const NodeCaps& caps) {
  const auto changed = [&](std::span<const std::int32_t> bricks) {
    for (const std::int32_t b : bricks) {
      const Vec3i low = kBrickNodes * brick(b);
      capsChanged(low, low + Vec3i::Constant(kBrickNodes - 1));
    }
  };
  changed(capped_), changed(caps.bricks());
  capped_.clear();
}

// Whether the surface may run through grid cells of the brick because of caps.
bool ColourField::cappedNear(const Vec3i& b, const NodeCaps& caps) const {
  if (caps.empty()) return false;
  const Vec3i high = (b + Vec3i::Ones()).cwiseMin(brickDims_ - Vec3i::Ones());
  for (int z = b.z(); z <= high.z(); ++z)
    for (int y = b.y(); y <= high.y(); ++y)
      for (int x = b.x(); x <= high.x(); ++x)
        if (caps.of(brickIndex({x, y, z}))) return true;
  return false;
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

std::span<const std::int64_t> ColourField::update(const NodeCaps& caps) {
  // Kept until all are evaluated: the evaluation can be stopped (base/stop.h).
  std::sort(pending_.begin(), pending_.end());
  pending_.erase(std::unique(pending_.begin(), pending_.end()), pending_.end());
  touched_ = pending_;
  if (originalOf_.empty() && !touched_.empty()) {
    originalOf_.assign(slotOf_.size(), kUnedited);
    builtBricks_ = RawArray<std::int32_t>();
  }
  for (const std::int64_t b : touched_) {
    std::int32_t& s = slotOf_[b];
    if (!edited(b)) {
      originalOf_[b] = s < 0 ? s : slotsOf(originals_);
      if (s >= 0) originals_.insert(originals_.end(), values(s).begin(), values(s).end());
    }
    const PaddedCells::Held now = held(brick(b));
    if (now == PaddedCells::Held::Mixed ||
        (now == PaddedCells::Held::All && cappedNear(brick(b), caps))) {
      if (s < 0) {
        s = takeSlot();
        pendingOf_[b] |= kAllPlanes;
      }
    } else {
      if (s >= 0) freeSlots_.push_back(s);
      s = now == PaddedCells::Held::Nothing ? kEmpty : kFull;
    }
  }
  parallelFor(touched_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::int64_t b = touched_[i];
      const unsigned planes = pendingOf_[b] & kAllPlanes;
      pendingOf_[b] = 0;
      if (slotOf_[b] < 0 || planes == 0) continue;
      float* nodes = values_.data() + firstNode(slotOf_[b]);
      evaluate(brick(b), planes, nodes);
      if (const NodeCaps::Brick* cap = caps.of(b))
        for (std::size_t n = 0; n < kBrickSize; ++n)
          if ((planes >> n / 16 & 1) && (*cap)[n] < NodeCaps::kNone)
            nodes[n] = capped(nodes[n], (*cap)[n] / 2.f);
    }
  });
  pending_.clear();
  if (capped_.size() != caps.bricks().size())
    capped_.assign(caps.bricks().begin(), caps.bricks().end());
  return touched_;
}

bool ColourField::cellsEdited(std::int64_t b) const {
  if (originalOf_.empty()) return false;
  const Vec3i low = brick(b), high = (low + Vec3i::Ones()).cwiseMin(brickDims_ - Vec3i::Ones());
  for (int z = low.z(); z <= high.z(); ++z)
    for (int y = low.y(); y <= high.y(); ++y)
      for (int x = low.x(); x <= high.x(); ++x)
        if (edited(brickIndex({x, y, z}))) return true;
  return false;
}

std::size_t ColourField::bytes() const {
  return cells_.bytes() + (values_.capacity() + originals_.capacity()) * sizeof(float) +
         (slotOf_.capacity() + builtBricks_.capacity() + originalOf_.capacity()) *
             sizeof(std::int32_t) +
         pendingOf_.capacity() + capped_.capacity() * sizeof(std::int32_t);
}

}  // namespace resect
