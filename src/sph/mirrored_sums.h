// Cells in mirror places round a node are added first, then weighed: what the sums over numbers
// (sph/field_stencil.cpp) and over levels (sph/level_stencil.cpp) have in common. For them alone.
//
// Inlined, so that it is made for the instruction set of the function that calls it.
#pragma once

#include <cstring>
#include <type_traits>

#include "sph/field_stencil.h"

// Every function that gives such vectors is inlined: how they would be passed does not matter.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace resect {

// The four nodes of a row of a brick, and two rows, which machines with eight lanes add at once.
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

// The sums of cells in mirror places round a node along an axis: the nearest (its own cell, or the
// two that it lies between) and those one further.
template <typename T>
struct Mirrored {
  T near, far;
};

// Two nodes a cell. For node i of a brick along an axis, from the cells (or sums of cells) along
// it.
template <typename At>
[[gnu::always_inline]] inline auto mirrored(int i, At at) {
  using T = std::decay_t<decltype(at(0))>;
  const int h = i / 2;
  if (i % 2 == 0) return Mirrored<T>{at(h + 1), at(h) + at(h + 2)};
  return Mirrored<T>{at(h + 1) + at(h + 2), at(h) + at(h + 3)};
}

// Does a node at such a place along y and z reach the cells that are one further along the axes
// named by the bits of k (x, y, z)? Midway between cells it is half a cell nearer to some.
constexpr bool reaches(int y, int z, int k) {
  const auto square = [](int node, bool further) {  // in half cells
    return (node % 2 + 2 * further) * (node % 2 + 2 * further);
  };
  return square(0, k & 1) + square(y, k & 2) + square(z, k & 4) < 16;
}

// Two nodes a cell: of the cells along x and y, as rows 0 and 2 of a brick's nodes see them, which
// lie alike in neighbouring rows of cells, and as rows 1 and 3 do; per plane of cells, x fastest.
constexpr int kCellsBetween = 5;  // that a brick reaches along an axis
using SumsBetween = Half[2][kCellsBetween][4];

// Aims, with what makes the sums, at 27 sums and products a node, eight nodes at a time.
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
