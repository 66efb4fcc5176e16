// The colour values of a lattice's cells (percentages of each cell's volume that are tissue), with
// a halo of empty cells round them, so that no reader has to test for the lattice's bounds.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/vec.h"
#include "sph/discretization.h"
#include "sph/held_bits.h"

namespace resect {

class PaddedCells {
 public:
  // Width of the halo before the first cell and after the last one along each axis, in cells.
  static constexpr int kBelow = 3, kAbove = 7;

  PaddedCells() = default;
  // held: receives the occupancy masks (sph/held_bits.h), one row for each row of cells along x,
  // halo included.
  PaddedCells(const Discretization& cells, HeldBits& held);

  const Vec3i& dims() const { return dims_; }
  // Index of a cell, x fastest. cell: coordinates of the cell in the lattice. In the halo,
  // coordinates go down to -kBelow.
  std::int64_t index(const Vec3i& cell) const {
    const Vec3i c = cell + Vec3i::Constant(kBelow);
    return (std::int64_t(c.z()) * dims_.y() + c.y()) * dims_.x() + c.x();
  }
  float value(std::int64_t at) const { return values_[std::size_t(at)]; }
  // value: in [0, 100]. ColourValues::set() says what a call costs.
  void set(std::int64_t at, float value) { values_.set(std::size_t(at), value); }
  // Whether the cells of a box are all empty (Nothing), all full (All), or neither (Mixed). low:
  // coordinates in the lattice of the box's lowest cell. dims: number of the box's cells along each
  // axis.
  enum class Held { Nothing, All, Mixed };
  Held heldIn(const Vec3i& low, const Vec3i& dims) const;
  // Calls look(cells), where `cells` points to the value of the cell with index `at`. The values of
  // the cells with higher indices follow in memory. The values are levels (std::uint8_t) or colour
  // values (float).
  template <typename Look>
  [[gnu::always_inline]] void lookAt(std::int64_t at, Look look) const {
    values_.areLevels() ? look(values_.levels().data() + at) : look(values_.numbers().data() + at);
  }

  std::size_t bytes() const { return values_.bytes(); }

 private:
  Vec3i dims_ = Vec3i::Zero();
  ColourValues values_;
};

}  // namespace resect
