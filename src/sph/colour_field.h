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
// changed cells, whatever the size of the organ.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sph/discretization.h"

namespace resect {

constexpr int kBrickNodes = 4;                // along each axis
constexpr int kBrickSize = 64;                // nodes of a brick
constexpr double kSmoothingPerSpacing = 0.8;  // h / spacing: support of exactly two cells
// Between these iso levels a surface never runs through the inside of solid tissue, where c is 99.1
// to 100.9.
constexpr float kMinIso = 1, kMaxIso = 98;

class ColourField {
 public:
  static constexpr std::int32_t kEmpty =
      -1;                                    // all nodes of the brick, and of the next plane, are 0
  static constexpr std::int32_t kFull = -2;  // all of them lie in solid tissue

  // refine: nodes per cell, 1 to 4. Evaluates all bricks.
  ColourField(const Discretization& cells, int refine);

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
    const std::int64_t row = index / brickDims_.x();
    return {int(index % brickDims_.x()), int(row % brickDims_.y()), int(row / brickDims_.y())};
  }

  // kEmpty, kFull or a slot >= 0. Slots are reused; their number is slotCount().
  std::int32_t slot(std::int64_t brick) const { return slotOf_[brick]; }
  std::int32_t slotCount() const { return std::int32_t(values_.size() / kBrickSize); }
  // The 64 nodes of a stored brick, x fastest.
  std::span<const float, kBrickSize> values(std::int32_t slot) const {
    return std::span<const float, kBrickSize>(values_.data() + std::size_t(slot) * kBrickSize,
                                              kBrickSize);
  }
  float node(const Vec3i& node) const;         // 0 outside the grid
  Vec3 nodePosition(const Vec3& node) const {  // rest space, m; fractional nodes allowed
    return lattice_.origin + lattice_.spacing.cwiseProduct(node / refine_ - Vec3::Constant(2));
  }

  float cellValue(std::int64_t cell) const { return cells_[padded(lattice_.cell(cell))]; }
  // Sets a cell's colour value, in [0, 100]; the field follows at the next update().
  void setCellValue(std::int64_t cell, float value);
  // Evaluates the bricks in reach of the cells set since the last call; returns them, ascending,
  // each once. Includes the bricks that hold no changed node but a vertex or normal that depends on
  // one. Valid until the next call.
  std::span<const std::int64_t> update();

  // A node's value from the cells as they were when the field was built: what was tissue before any
  // edit. Inside the grid.
  float originalNode(const Vec3i& node) const;
  // Was a cell in reach of the brick's nodes changed since the field was built?
  bool edited(std::int64_t brick) const { return edited_[brick] != 0; }

  std::size_t bytes() const;  // memory held

 private:
  struct Tap {
    std::int32_t offset;  // into the window of cells round a brick
    float weight;
  };
  static constexpr int kPad =
      6;  // cells of zero round the lattice, so that windows need no bounds test
  static constexpr int kWindow = 7;  // cells along each axis that a brick can reach
  enum class Reach { Empty, Full, Mixed };

  std::int64_t padded(const Vec3i& cell) const {
    return (std::int64_t(cell.z() + kPad) * paddedDims_.y() + cell.y() + kPad) * paddedDims_.x() +
           cell.x() + kPad;
  }
  Vec3i windowCell(const Vec3i& brick) const;
  Reach reach(const Vec3i& brick) const;
  void evaluate(const Vec3i& brick, float* out) const;
  std::int32_t takeSlot();

  Lattice lattice_;
  int refine_;
  Vec3i brickDims_, paddedDims_;
  std::vector<std::vector<Tap>> taps_;  // per position of a node in its cell, x fastest
  std::vector<float> fullValues_;       // value of a node in solid tissue, per position
  std::vector<float> cells_;            // padded colour values now
  std::vector<float> originalCells_;    // and when the field was built
  std::vector<std::int32_t> slotOf_;    // per brick
  std::vector<std::uint8_t> edited_;    // per brick
  std::vector<float> values_;           // kBrickSize per slot
  std::vector<std::int32_t> freeSlots_;
  std::vector<std::int64_t> pending_;  // bricks in reach of cells set since the last update
  std::vector<std::int64_t> touched_;  // what the last update gave out
};

}  // namespace resect
