// Mirrored sums: the values of cells that have equal weights for a node are added first, and their
// sum is then multiplied by the weight. Used only by the sums over floats (sph/field_stencil.cpp)
// and over levels (sph/level_stencil.cpp).
//
// All functions are inlined, so that they are compiled for the instruction set of their caller.
#pragma once

#include <cstring>
#include <type_traits>

#include "sph/field_stencil.h"

// -Wpsabi warns about the calling convention of functions that return vectors. The warning does not
// matter here, since all these functions are inlined.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace resect {

// A brick has 4 x 4 x 4 nodes. Row: the values of the four nodes of a row of a brick. Half: the
// values of two rows, which are half a plane of a brick. Half suits processors with vectors of
// eight floats.
typedef float Row __attribute__((vector_size(16)));
typedef float Half __attribute__((vector_size(32)));

[[gnu::always_inline]] inline Row rowAt(const float* values) {
  Row row;
  std::memcpy(&row, values, sizeof row);
  return row;
}
[[gnu::always_inline]] inline Half join(const Row& first, const Row& second) {
  return __builtin_shufflevector(first, second, 0, 1, 2, 3, 4, 5, 6, 7);
}
[[gnu::always_inline]] inline Half half(const FieldStencil::HalfPlane& numbers) {
  Half half;
  std::memcpy(&half, numbers.data(), sizeof half);
  return half;
}

// The two mirrored sums along an axis. near: the value of the node's own cell; if the node lies
// between two cells, the sum of their values. far: the sum of the values of the next cell on each
// side.
template <typename T>
struct Mirrored {
  T near, far;
};

// With two nodes per cell: the mirrored sums along an axis, for the node that has the index i (0 to
// 3) on this axis. at(k): the value of cell k along the axis, counted from the lowest cell in the
// reach of the brick. at() may return the value of one cell, a vector of such values, or a mirrored
// sum along another axis.
template <typename At>
[[gnu::always_inline]] inline auto mirrored(int i, At at) {
  using T = std::decay_t<decltype(at(0))>;
  const int h = i / 2;
  if (i % 2 == 0) return Mirrored<T>{at(h + 1), at(h) + at(h + 2)};
  return Mirrored<T>{at(h + 1) + at(h + 2), at(h) + at(h + 3)};
}

// With two nodes per cell: whether any node of a row reaches the cells of a mirrored sum. y, z: the
// indices of the row in the brick. k: number of the sum, with one bit per axis (1 for x, 2 for y, 4
// for z). A set bit stands for the far cells along that axis, a clear bit for the near ones. Nodes
// with odd indices lie midway between cells.
constexpr bool reaches(int y, int z, int k) {
  const auto square = [](int node, bool further) {  // squared distance along an axis, in half cells
    return (node % 2 + 2 * further) * (node % 2 + 2 * further);
  };
  return square(0, k & 1) + square(y, k & 2) + square(z, k & 4) < 16;
}

// With two nodes per cell: number of cells in reach of a brick along an axis.
constexpr int kCellsBetween = 5;
// SumsBetween: with two nodes per cell, the mirrored sums along x and y. First index: 0 for rows 0
// and 2 of a brick's nodes, which lie on cell centres along y; 1 for rows 1 and 3, which lie midway
// between cell centres. Second index: number of the plane of cells. Third index: number of the sum,
// with bit 0 for x and bit 1 for y. A bit is 0 for near cells and 1 for far cells.
using SumsBetween = Half[2][kCellsBetween][4];

// Evaluates planes of a brick from the mirrored sums along x and y. Plane z is evaluated if bit z
// of `planes` is set. Eight nodes are processed at a time. This takes about 19 additions and
// products per node; together with the sums along x and y, which the caller computes, about 27 per
// node.
[[gnu::always_inline]] inline void weighBetween(const FieldStencil& stencil,
                                                const SumsBetween& sumsOf, unsigned planes,
                                                float* out) {
#pragma GCC unroll 2
  for (int row = 0; row < 2; ++row) {
    const auto& sums = sumsOf[row];
#pragma GCC unroll 4
    for (int plane = 0; plane < kBrickNodes; ++plane) {
      if (!(planes >> plane & 1)) continue;
      const auto& weight = stencil.mirrored[std::size_t(row)][std::size_t(plane % 2)];
      Half sum = {};
#pragma GCC unroll 4
      for (int k = 0; k < 4; ++k) {
        const auto both = mirrored(plane, [&](int z) { return sums[z][k]; });
        sum += reaches(row, plane, k + 4) ? both.near * half(weight[std::size_t(k)]) +
                                                both.far * half(weight[std::size_t(4 + k)])
                                          : both.near * half(weight[std::size_t(k)]);
      }
      float* to = out + (plane * kBrickNodes + row) * kBrickNodes;
      const Row first = __builtin_shufflevector(sum, sum, 0, 1, 2, 3),
                second = __builtin_shufflevector(sum, sum, 4, 5, 6, 7);
      std::memcpy(to, &first, sizeof first);
      std::memcpy(to + 2 * kBrickNodes, &second, sizeof second);
    }
  }
}

}  // namespace resect
