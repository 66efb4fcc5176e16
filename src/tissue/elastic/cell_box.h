// Memory layout of the cells of an organ's lattice: a dense box of cells with a halo, a border of
// empty cells. The 26 neighbours of a cell have fixed index offsets from the cell. Rows can be read
// sixteen cells at a time.
//
// x is fastest. Each row (along x) ends with at least one empty cell. This cell also lies before
// the first cell of the next row. Each plane (along x and y) ends with an empty row, which also
// lies before the first row of the next plane. The box has an empty plane at each end. So if a
// neighbour of a cell lies outside the lattice, it is an empty cell of the box.
#pragma once

#include <array>
#include <cstdint>

#include "base/state/state_visitor.h"
#include "base/vec.h"
#include "tissue/stencil.h"

namespace resect {

inline constexpr int kChunk = 16;  // cells processed together; divides the length of a row

struct CellBox {
  Vec3i dims = Vec3i::Zero();                    // cells of the lattice along each axis
  std::int32_t strideY = 0, strideZ = 0;         // index offsets to the next cell along y and z
  std::int32_t front = 0;                        // number of cells before cell (0, 0, 0)
  std::int32_t size = 0;                         // number of all cells, halo included
  std::array<std::int32_t, kDirections> step{};  // index offset of the neighbour in each direction

  CellBox() = default;
  // cells: number of cells along each axis, >= 1. The box may have at most 2^31 - 1 cells, halo
  // included.
  explicit CellBox(const Vec3i& cells) : dims(cells) {
    const auto roundUp = [](int n) { return (n + kChunk - 1) / kChunk * kChunk; };
    strideY = roundUp(dims.x() + 1);
    strideZ = strideY * (dims.y() + 1);
    front = strideZ + strideY + kChunk;
    size = front + strideZ * dims.z() + strideZ + strideY + kChunk;
    for (int d = 0; d < kDirections; ++d) {
      const Vec3i o = offsetOf(d);
      step[d] = o.x() + o.y() * strideY + o.z() * strideZ;
    }
  }
  CellOrder order() const { return {front, strideY, strideZ}; }
  std::int32_t index(const Vec3i& c) const {
    return front + c.x() + c.y() * strideY + c.z() * strideZ;
  }
  Vec3i cell(std::int32_t index) const {
    const std::int32_t i = index - front;
    return {i % strideY, i / strideY % (dims.y() + 1), i / strideZ};
  }
  // Whether the index is that of a cell of the lattice; false for a cell of the halo.
  bool inLattice(std::int32_t index) const {
    if (index < front || index >= size) return false;
    const Vec3i c = cell(index);
    return c.x() < dims.x() && c.y() < dims.y() && c.z() < dims.z();
  }
  // Conversion from and to a cell's index in the lattice (x fastest, no halo).
  std::int32_t fromLattice(std::int64_t cell) const {
    const std::int64_t row = cell / dims.x();
    return index({int(cell % dims.x()), int(row % dims.y()), int(row / dims.y())});
  }
  std::int64_t toLattice(std::int32_t index) const {
    const Vec3i c = cell(index);
    return (std::int64_t(c.z()) * dims.y() + c.y()) * dims.x() + c.x();
  }
};

}  // namespace resect
