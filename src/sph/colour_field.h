// The SPH colour field of a lattice organ, on a grid of nodes stored in sparse bricks.
//
// The field at a node is c = sum over cells j of A_j V W(r - r_j, h), equation 3.6 of the diploma
// thesis that Resect continues. A_j is the colour value of cell j, 0 to 100; V is the volume of a
// cell; W is the kernel (sph/kernel.h) with smoothing length h = 0.8 spacing; r is the position of
// the node; r_j is the centre of cell j. The lattice is regular, so for each position of a node
// within its cell the sum is a fixed stencil of at most 36 cells. Distances are measured in cells.
// So on a lattice with unequal spacings, the kernel is stretched in the same way as the cells.
// There are `refine` nodes per cell along each axis. Along each axis node 0 lies two cells below
// the centre of cell 0, so the field at the outermost nodes is always 0. A "cell" here is a cell of
// the lattice. A "grid cell" is a box with eight neighbouring nodes as its corners.
//
// Nodes are held in bricks of 4 x 4 x 4 nodes. A brick is stored if the surface can pass through
// it. In all other bricks the values of the nodes are known: all cells in the brick's reach (the
// cells that have a weight at one of its nodes) are empty, or all are full. A change of a cell is
// never added to the field or subtracted from it. Instead, all bricks that have the cell in their
// reach are evaluated again. So the field depends on the present cells alone, bit for bit. The cost
// of a change depends on the number of these bricks, not on the size of the organ. The first change
// also writes 5 bytes for each brick of the grid.
//
// Where an instrument has carved, the field at a node is at most the node's cap (sph/node_caps.h).
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
#include "sph/node_caps.h"
#include "sph/padded_cells.h"

namespace resect {

// At iso levels in this range no surface runs inside solid tissue, where c is 99.1 to 100.9.
constexpr float kMinIso = 1, kMaxIso = 98;
void requireIso(float iso);  // throws Error for a level out of this range

class ColourField {
 public:
  // The slot of a brick is the number under which its nodes are stored. A brick that is not stored
  // has one of the following two values as its slot. kEmpty: the field is 0 at all nodes of the
  // brick. kFull: all nodes of the brick lie in solid tissue. Both statements also hold for the
  // planes of nodes just above the brick, which belong to the next bricks.
  static constexpr std::int32_t kEmpty = -1;
  static constexpr std::int32_t kFull = -2;

  // Whether the lattice's bricks can be numbered with 32 bits.
  static bool canHold(const Lattice& lattice, int refine);
  // refine: nodes per cell along each axis, 1 to 4. canHold() must be true. Evaluates all bricks.
  ColourField(const Discretization& cells, int refine);
  // As above, but does not evaluate the stored bricks. The caller must evaluate these bricks with
  // evaluateBuilt(). So the caller can read the nodes of a brick soon after they were evaluated,
  // while they are still in the cache.
  struct NodesLater {};
  ColourField(const Discretization& cells, int refine, NodesLater);
  // The bricks that were stored when the field was built, in ascending order. The i-th of these
  // bricks has slot i. The span is valid until the first update() after a change.
  std::span<const std::int32_t> builtBricks() const { return builtBricks_; }
  void evaluateBuilt(std::size_t begin, std::size_t end);  // evaluates builtBricks()[begin, end)

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
    // Brick numbers fit 32 bits, and a 32-bit division takes half the time.
    const auto i = std::uint32_t(index), dimX = std::uint32_t(brickDims_.x()),
               dimY = std::uint32_t(brickDims_.y());
    return {int(i % dimX), int(i / dimX % dimY), int(i / dimX / dimY)};
  }

  // kEmpty, kFull or a slot from 0 to slotCount() - 1. Slots of bricks that are no longer stored
  // are reused.
  std::int32_t slot(std::int64_t brick) const { return slotOf_[brick]; }
  std::int32_t slotCount() const { return slotsOf(values_); }
  // The 64 nodes of a stored brick, x fastest.
  std::span<const float, kBrickSize> values(std::int32_t slot) const {
    return std::span<const float, kBrickSize>(values_.data() + firstNode(slot), kBrickSize);
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
  // The bricks whose grid cells meet a box (rest space, m; may be infinite).
  IndexBox bricksIn(const Aabb& box) const;

  float cellValue(std::int64_t cell) const {
    return cells_.value(cells_.index(lattice_.cell(cell)));
  }
  // Sets a cell's colour value, in [0, 100]. The next update() evaluates the field again.
  void setCellValue(std::int64_t cell, float value);
  // The nodes from low to high have other caps: the next update() evaluates the field again.
  void capsChanged(const Vec3i& low, const Vec3i& high);
  // All caps may be others than at the last update(), since a state was restored.
  void capsRestored(const NodeCaps& caps);
  // Evaluates the bricks in reach of the cells and caps that were changed since the last update().
  // Returns these bricks, in ascending order, each once. A returned brick may have no changed node:
  // a vertex or normal of the brick then depends on a changed node of another brick. The span is
  // valid until the next call. caps: of all nodes, the same at each call but for what
  // capsChanged() and capsRestored() told.
  std::span<const std::int64_t> update(const NodeCaps& caps = NodeCaps());

  // Whether a cell in reach of the brick's nodes, or a cap, was changed since the field was built.
  bool edited(std::int64_t brick) const {
    return !originalOf_.empty() && originalOf_[brick] != kUnedited;
  }
  // Whether edited() holds for the brick or for a brick above it. The upper grid cells of the brick
  // also use nodes of the bricks above.
  bool cellsEdited(std::int64_t brick) const;
  // The results that nodes() and node() had when the field was built, before any edit.
  const float* originalNodes(const Vec3i& brick) const {
    const std::int64_t b = brickIndex(brick);
    return edited(b) ? nodesOf(b, originalOf_[b], originals_) : nodes(b);
  }
  float originalNode(const Vec3i& node) const;  // inside the grid

  std::size_t bytes() const;  // memory held

 private:
  static constexpr std::int32_t kUnedited = -3;
  // node / refine. If refine is 1, 2 or 4, no division is needed.
  int cellOf(int node) const { return refine_ == 3 ? node / 3 : node >> refine_ / 2; }
  // Per axis: position of a brick's first node within the cell of this node, 0 to refine - 1.
  // Always 0 for refine 1, 2 and 4.
  Vec3i phase(const Vec3i& brick) const {
    if (stencil_->phases == 1) return Vec3i::Zero();
    const auto along = [&](int b) { return kBrickNodes * b % refine_; };
    return {along(brick.x()), along(brick.y()), along(brick.z())};
  }
  // Index of a slot's first node in an array of bricks; `slot` may be kFull or kEmpty. The array
  // begins with a full brick (for kFull) and an empty brick (for kEmpty). So the nodes of a brick
  // are found without a test whether the brick is stored.
  static std::size_t firstNode(std::int32_t slot) { return std::size_t(slot - kFull) * kBrickSize; }
  static std::int32_t slotsOf(const RawArray<float>& bricks) {
    return std::int32_t(bricks.size() / kBrickSize) + kFull;
  }
  void putFullAndEmpty(RawArray<float>& bricks) const;
  const float* nodesOf(std::int64_t b, std::int32_t slot, const RawArray<float>& bricks) const {
    if (stencil_->phases > 1) [[unlikely]]
      return nodesByPhase(b, slot, bricks);
    return bricks.data() + firstNode(slot);
  }
  // nodesOf() for refine 3, where full bricks with different phases differ. This is a separate
  // function, so that nodesOf() usually needs no branch on the slot. The processor could not
  // predict such a branch.
  const float* nodesByPhase(std::int64_t b, std::int32_t slot, const RawArray<float>& bricks) const;
  void classifyBricks(const HeldBits& held);
  std::int32_t classifyRow(const HeldBits& held, std::size_t row, std::uint64_t* bits,
                           std::int32_t* mixed);
  Vec3i windowCell(const Vec3i& brick) const;
  int highestCell(int brick) const;
  PaddedCells::Held held(const Vec3i& brick) const;
  void evaluate(const Vec3i& brick, unsigned planes, float* out) const;
  bool cappedNear(const Vec3i& brick, const NodeCaps& caps) const;
  void touch(std::int64_t brick, unsigned planes);
  std::int32_t takeSlot();

  Lattice lattice_;
  int refine_;
  const FieldStencil* stencil_;
  Vec3i brickDims_;
  PaddedCells cells_;              // present colour values
  RawArray<std::int32_t> slotOf_;  // per brick
  RawArray<std::int32_t> builtBricks_;
  RawArray<float> values_;  // the nodes of stored bricks, at firstNode(slot)
  std::vector<std::int32_t> freeSlots_;
  // Per brick: kUnedited; or, for an edited brick, the place of its node values from before any
  // edit: a slot of originals_, kFull or kEmpty. The vector has no elements before the first
  // change.
  std::vector<std::int32_t> originalOf_;
  RawArray<float> originals_;  // nodes of edited bricks before any edit
  // Per brick: the bit kPending, and one bit for each plane of nodes that update() must evaluate.
  // The vector has no elements before the first change.
  std::vector<std::uint8_t> pendingOf_;
  std::vector<std::int64_t> pending_;  // bricks in reach of cells set since the last update
  std::vector<std::int64_t> touched_;  // result of the last update
  std::vector<std::int32_t> capped_;   // bricks that had caps at the last update
};

}  // namespace resect
