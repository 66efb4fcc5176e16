// The regular lattice of an organ's cells in rest space, and their numbering.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "base/state/state_visitor.h"
#include "base/vec.h"
#include "geometry/aabb.h"

namespace resect {

// A regular grid of cells. Cell (i, j, k) is a box with the sides `spacing`. Its centre is origin +
// (i, j, k) * spacing, axis by axis. Its index is (k * dims.y + j) * dims.x + i: x is fastest.
struct Lattice {
  Vec3 origin = Vec3::Zero();   // centre of cell (0, 0, 0), m
  Vec3 spacing = Vec3::Ones();  // > 0, m; the three must be equal if the organ can deform
  Vec3i dims = Vec3i::Zero();   // cells along each axis, >= 0

  std::int64_t cellCount() const { return std::int64_t(dims.x()) * dims.y() * dims.z(); }
  double cellVolume() const { return spacing.prod(); }  // m^3
  bool cubic() const {
    return std::abs(spacing.maxCoeff() - spacing.minCoeff()) <= 1e-6 * spacing.maxCoeff();
  }
  // Whether origin, spacing and dims are in their ranges.
  bool sound() const {
    return origin.allFinite() && spacing.allFinite() && (spacing.array() > 0).all() &&
           (dims.array() >= 0).all();
  }
  bool contains(const Vec3i& cell) const {
    return (cell.array() >= 0).all() && (cell.array() < dims.array()).all();
  }
  std::int64_t index(const Vec3i& cell) const {
    return (std::int64_t(cell.z()) * dims.y() + cell.y()) * dims.x() + cell.x();
  }
  Vec3i cell(std::int64_t index) const {
    const std::int64_t row = index / dims.x();
    return {int(index % dims.x()), int(row % dims.y()), int(row / dims.y())};
  }
  Vec3 centre(const Vec3i& cell) const {
    return origin + spacing.cwiseProduct(cell.cast<double>());
  }
  // Cell coordinates of a point: (0, 0, 0) at the centre of the first cell.
  Vec3 toCellSpace(const Vec3& p) const { return (p - origin).cwiseQuotient(spacing); }
  // The cell that a point lies in; none outside the lattice.
  std::optional<Vec3i> cellAt(const Vec3& p) const {
    const Vec3 at = toCellSpace(p);
    Vec3i cell;
    for (int a = 0; a < 3; ++a) {
      if (!(at[a] >= -0.5 && at[a] < dims[a] - 0.5)) return {};
      cell[a] = int(std::floor(at[a] + 0.5));
    }
    return cell;
  }
  CellOrder order() const { return {0, dims.x(), std::int64_t(dims.x()) * dims.y()}; }

  // The box that all cells together fill.
  Aabb box() const {
    return {origin - 0.5 * spacing,
            origin + spacing.cwiseProduct(dims.cast<double>() - Vec3::Constant(0.5))};
  }
};

// Calls visit(const Vec3i& cell) for the cells whose centres lie in the box or on its sides, x
// fastest.
template <typename Visit>
void visitCellsIn(const Lattice& lattice, const Aabb& box, Visit visit) {
  constexpr double kOnSide = 1e-9;  // tolerance, in spacings
  Vec3i first, last;
  for (int a = 0; a < 3; ++a) {
    const double most = lattice.dims[a];  // double: huge boxes are clamped before conversion
    first[a] = int(std::ceil(std::clamp(lattice.toCellSpace(box.min)[a] - kOnSide, 0.0, most)));
    last[a] =
        int(std::floor(std::clamp(lattice.toCellSpace(box.max)[a] + kOnSide, -1.0, most - 1)));
  }
  for (int z = first.z(); z <= last.z(); ++z)
    for (int y = first.y(); y <= last.y(); ++y)
      for (int x = first.x(); x <= last.x(); ++x) visit(Vec3i(x, y, z));
}

}  // namespace resect
