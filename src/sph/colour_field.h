// How much tissue is there at each node of a fine grid? The SPH colour field of a lattice organ, on
// sparse bricks.
//
// c(node) = sum over cells j of A_j V W(r - r_j, h) with h = 0.8 spacing: equation 3.6 of the
// thesis with the colour value A_j in [0, 100]. The rest lattice is regular, so the sum is a fixed
// stencil of at most 36 taps per position of a node within its cell, the same everywhere; distances
// are taken in cells, so a lattice with unequal spacings is served by a kernel stretched alike.
// Nodes lie `refine` to a cell; node 0 lies two cells below the centre of cell 0, so that the
// outermost nodes are always 0.
//
// Nodes are held in bricks of 4 x 4 x 4. A brick is stored only where the surface can be; where all
// cells in reach are empty or all are full its nodes are known without being stored. A changed cell
// is never added or subtracted: the bricks that it reaches are evaluated again, so that the field
// depends on the present cells alone, bit for bit. Cost of a change: the bricks in reach of the
// changed cells, whatever the size of the organ; of the first one also 5 bytes for each brick of
// the grid, to remember by.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/index_box.h"
#include "base/raw_array.h"
#include "geometry/aabb.h"
#include "sph/discretization.h"
#include "sph/field_stencil.h"
#include "sph/padded_cells.h"

namespace resect {

// Between these iso levels a surface never runs through the inside of solid tissue, where c is 99.1
// to 100.9.
constexpr float kMinIso = 1, kMaxIso = 98;

class ColourField {
 public:
  static constexpr std::int32_t kEmpty =
      -1;                                    // all nodes of the brick, and of the next plane, are 0
  static constexpr std::int32_t kFull = -2;  // all of them lie in solid tissue

  // Bricks are numbered with 32 bits: has a lattice no more of them?
  static bool canHold(const Lattice& lattice, int refine);
  // refine: nodes per cell, 1 to 4; canHold(). Evaluates all bricks.
  ColourField(const Discretization& cells, int refine);
  // The same without the nodes of stored bricks, which are left to evaluateBuilt(): for who reads
  // them as they come, while they are still in the cache.
  struct NodesLater {};
  ColourField(const Discretization& cells, int refine, NodesLater);
  // The bricks that were stored when the field was built, ascending; the i-th has slot i. Known
  // until the first edit.
  std::span<const std::int32_t> builtBricks() const { return builtBricks_; }
  void evaluateBuilt(std::size_t begin, std::size_t end);  // a part of them

  const Lattice& lattice() const { return lattice_; }
  int refine() const { return refine_; }
  Vec3i nodeDims() const { return brickDims_ * kBrickNodes; }
  Vec3i brickDims() const { return brickDims_; }
  std::int64_t brickCount() const {
    return std::int64_t(brickDims_.x()) * brickDims_.y() * brickDims_.z();
  }
  std::int64_t brickIndex(const Vec3i& b) const {
    return (std::int64_t(b.z()) * brickDims_.y() + b.y()) * brickDims_.x() + b.x();
  }
  Vec3i brick(std::int64_t index) const {
    // Numbers of 32 bits are divided in half the time, and there are never more bricks.
    const auto i = std::uint32_t(index), dimX = std::uint32_t(brickDims_.x()),
               dimY = std::uint32_t(brickDims_.y());
    return {int(i % dimX), int(i / dimX % dimY), int(i / dimX / dimY)};
  }

  // kEmpty, kFull or a slot >= 0. Slots are reused; their number is slotCount().
  std::int32_t slot(std::int64_t brick) const { return slotOf_[brick]; }
  std::int32_t slotCount() const { return slotsOf(values_); }
  // The 64 nodes of a stored brick, x fastest.
  std::span<const float, kBrickSize> values(std::int32_t slot) const {
    return std::span<const float, kBrickSize>(values_.data() + place(slot), kBrickSize);
  }
  // The 64 nodes of any brick of the grid, stored or not.
  const float* nodes(std::int64_t brick) const { return nodesOf(brick, slotOf_[brick], values_); }
  const float* nodes(const Vec3i& brick) const { return nodes(brickIndex(brick)); }
  float node(const Vec3i& node) const;         // 0 outside the grid
  Vec3 nodePosition(const Vec3& node) const {  // rest space, m; fractional nodes allowed
    return {nodePlace(0, node.x()), nodePlace(1, node.y()), nodePlace(2, node.z())};
  }
  double nodePlace(int axis, double node) const {  // one coordinate of nodePosition()
    return lattice_.origin[axis] + lattice_.spacing[axis] * (node / refine_ - 2);
  }
  // The bricks whose cells a box meets (rest space, m; it may be endless).
  IndexBox bricksIn(const Aabb& box) const;

  float cellValue(std::int64_t cell) const {
    return cells_.value(cells_.place(lattice_.cell(cell)));
  }
  // Sets a cell's colour value, in [0, 100]; the field follows at the next update().
  void setCellValue(std::int64_t cell, float value);
  // Evaluates the bricks in reach of the cells set since the last call; returns them, ascending,
  // each once. Includes the bricks that hold no changed node but a vertex or normal that depends on
  // one. Valid until the next call.
  std::span<const std::int64_t> update();

  // Was a cell in reach of the brick's nodes changed since the field was built?
  bool edited(std::int64_t brick) const {
    return !originalOf_.empty() && originalOf_[brick] != kUnedited;
  }
  // nodes() and node() when the field was built: what was tissue before any edit.
  const float* originalNodes(const Vec3i& brick) const {
    const std::int64_t b = brickIndex(brick);
    return edited(b) ? nodesOf(b, originalOf_[b], originals_) : nodes(b);
  }
  float originalNode(const Vec3i& node) const;  // inside the grid

  std::size_t bytes() const;  // memory held

 private:
  static constexpr std::int32_t kUnedited = -3;
  // node / refine, without waiting for a quotient.
  int cellOf(int node) const { return refine_ == 3 ? node / 3 : node >> refine_ / 2; }
  // Place of a brick's first node within its cell, 0 to refine - 1, per axis: always 0 but for
  // refine 3.
  Vec3i phase(const Vec3i& brick) const {
    if (stencil_->phases == 1) return Vec3i::Zero();
    const auto along = [&](int b) { return kBrickNodes * b % refine_; };
    return {along(brick.x()), along(brick.y()), along(brick.z())};
  }
  // Where the nodes of a slot begin in an array of bricks, whose first two are one in solid tissue
  // (kFull) and an empty one (kEmpty): so any brick is found without asking which kind it is.
  static std::size_t place(std::int32_t slot) { return std::size_t(slot - kFull) * kBrickSize; }
  static std::int32_t slotsOf(const RawArray<float>& bricks) {
    return std::int32_t(bricks.size() / kBrickSize) + kFull;
  }
  void putFullAndEmpty(RawArray<float>& bricks) const;
  const float* nodesOf(std::int64_t b, std::int32_t slot, const RawArray<float>& bricks) const {
    if (stencil_->phases > 1) [[unlikely]]
      return nodesByPhase(b, slot, bricks);
    return bricks.data() + place(slot);
  }
  // The same where bricks in solid tissue differ. Apart, so that others are found without a branch
  // that depends on the slot: which neighbours are full no processor guesses.
  const float* nodesByPhase(std::int64_t b, std::int32_t slot, const RawArray<float>& bricks) const;
  void classifyBricks(const HeldBits& held);
  std::int32_t classifyRow(const HeldBits& held, std::size_t row, std::uint64_t* bits,
                           std::int32_t* mixed);
  Vec3i windowCell(const Vec3i& brick) const;
  int highestCell(int brick) const;
  PaddedCells::Held held(const Vec3i& brick) const;
  void evaluate(const Vec3i& brick, unsigned planes, float* out) const;
  std::int32_t takeSlot();

  Lattice lattice_;
  int refine_;
  const FieldStencil* stencil_;
  Vec3i brickDims_;
  PaddedCells cells_;              // now
  RawArray<std::int32_t> slotOf_;  // per brick
  RawArray<std::int32_t> builtBricks_;
  RawArray<float> values_;  // the nodes of stored bricks, by place()
  std::vector<std::int32_t> freeSlots_;
  // Per brick, from the first edit on: what slotOf_ was, into originals_.
  std::vector<std::int32_t> originalOf_;
  RawArray<float> originals_;  // values_ of the bricks edited since, before
  // Per brick, from the first edit on: kPending and the planes of nodes to evaluate.
  std::vector<std::uint8_t> pendingOf_;
  std::vector<std::int64_t> pending_;  // bricks in reach of cells set since the last update
  std::vector<std::int64_t> touched_;  // what the last update gave out
};

}  // namespace resect
