// The skin cells of an organ, over which blood runs. Tissue fills cells of the organ's lattice; a
// cell with tissue is also called a particle. A skin cell is a particle with a free face. A
// SkinCell describes the shape of the skin at the particle's free faces.
//
// A face of a particle is free if no bond crosses it. Such faces lie on the organ's surface, on the
// walls of a wound, and on the lips of an incision that is closed. All data here are derived from
// the organ and its tissue, so they are not saved.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "organ/operated_organ.h"
#include "tissue/stencil.h"

namespace resect {

// Numbers the cells of the organ's lattice and of one layer of empty cells round the lattice, x
// fastest. Thanks to the layer, every cell of the lattice has 26 neighbours.
struct PaddedNumbers {
  Vec3i dims = Vec3i::Zero();  // of the lattice
  std::int32_t step(int direction) const {
    return offsetAlong(direction, 0) +
           (dims.x() + 2) *
               (offsetAlong(direction, 1) + (dims.y() + 2) * offsetAlong(direction, 2));
  }
  std::int32_t of(const Vec3i& cell) const {
    return ((cell.z() + 1) * (dims.y() + 2) + cell.y() + 1) * (dims.x() + 2) + cell.x() + 1;
  }
  Vec3i cell(std::int32_t number) const {
    const std::int32_t row = number / (dims.x() + 2);
    return {number % (dims.x() + 2) - 1, row % (dims.y() + 2) - 1, row / (dims.y() + 2) - 1};
  }
  std::size_t count() const {
    return std::size_t(dims.x() + 2) * std::size_t(dims.y() + 2) * std::size_t(dims.z() + 2);
  }
};

struct SkinCell {
  // normal and offset are in rest space, the coordinates of the undeformed organ. normal: unit,
  // pointing out of the tissue. offset: vector from the cell's centre to its skin, m. In the bit
  // sets below, d is the number of the direction to a neighbour (tissue/stencil.h).
  Vec3f normal = Vec3f::Zero(), offset = Vec3f::Zero();
  float area = 0;          // area of the skin at this cell, at rest, m^2
  std::uint32_t free = 0;  // bit d: there is a particle in direction d; its bond is severed
  std::uint32_t ways = 0;  // bit d: blood can run to the skin cell in direction d
  std::uint32_t open = 0;  // bit d: the face in direction d is free (6 directions only)
  bool skin = false;
  bool slit = false;  // all free faces of the cell are lips of closed cuts
};

// How many faces of a cell have become free by a cut, a tear or the removal of tissue.
struct OpenedFaces {
  std::int64_t cell = -1;
  int faces = 0;
};

class SkinCells {
 public:
  SkinCells() = default;
  explicit SkinCells(const OperatedOrgan& organ);  // finds all skin cells

  // Call this after cuts, tears or the removal of tissue at `cells`. Updates all cells up to two
  // cells away from `cells` along each axis. Appends to `opened` the faces that have become free.
  void renew(const OperatedOrgan& organ, std::span<const std::int64_t> cells,
             std::vector<OpenedFaces>& opened);

  const SkinCell& operator[](std::int32_t number) const { return cells_[std::size_t(number)]; }
  bool isSkin(std::int32_t number) const { return cells_[std::size_t(number)].skin; }
  const PaddedNumbers& numbers() const { return numbers_; }
  const std::int32_t* steps() const { return steps_.data(); }  // numbers_.step() per direction
  std::int32_t numberOf(std::int64_t cell) const { return numbers_.of(lattice_.cell(cell)); }
  std::int64_t latticeCell(std::int32_t number) const {
    return lattice_.index(numbers_.cell(number));
  }
  const Lattice& lattice() const { return lattice_; }
  bool empty() const { return cells_.empty(); }

 private:
  void find(const OperatedOrgan& organ, const Vec3i& cell);
  void link(const Vec3i& cell);

  Lattice lattice_;
  PaddedNumbers numbers_;
  std::array<std::int32_t, kDirections> steps_{};
  std::vector<SkinCell> cells_;  // index: number of the cell
};

}  // namespace resect
