// Stencils of the colour field: the weights of the cells in reach of a node, and the weighted sums
// for the nodes of a brick.
//
// The rest lattice is regular, so nodes at the same position within their cells have the same
// weights. With one or two nodes per cell along an axis (refine 1 and 2), every node lies on a cell
// centre or midway between two centres, along each axis. Cells mirrored about the node then have
// equal weights. Their values are added first, axis by axis, which leaves four to eight products
// per node instead of up to 36. With refine 3 and 4 each cell is weighed by itself.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace resect {

constexpr int kBrickNodes = 4;                // nodes of a brick along each axis
constexpr int kBrickSize = 64;                // nodes of a brick
constexpr double kSmoothingPerSpacing = 0.8;  // h / spacing: the kernel's radius is two cells

struct FieldStencil {
  // Values for half a plane of a brick's nodes: two rows of four nodes.
  struct alignas(32) HalfPlane : std::array<float, 8> {};
  // The cells at one offset from the nodes of a plane, with their weights. The nodes lie at
  // different positions within their cells, so each node has its own weight; it is 0 where the cell
  // is out of the node's reach.
  struct Tap {
    std::array<HalfPlane, 2> weight;
    int offset;  // in a table of cells, from one below the node's own cell along each axis
  };

  int refine;  // nodes per cell along each axis, 1 to 4
  int phases;  // different phases of bricks along an axis: 3 for refine 3, else 1
  // For refine 1 and 2: weights of the mirrored sums. First index: 1 if the nodes lie midway
  // between cells in y, else 0. Second index: the same in z. Third index: which sum, one bit per
  // axis, x lowest: 0 for the nearest cells, 1 for the next ones.
  std::array<std::array<std::array<HalfPlane, 8>, 2>, 2> mirrored;
  // For refine 3 and 4: by phaseIndex() of the brick's phase in x and y, and of the plane's
  // position within its cell in z.
  std::vector<std::vector<Tap>> taps;
  std::vector<float> full;  // by phaseIndex(): the 64 node values of a brick in solid tissue

  std::size_t phaseIndex(const Vec3i& phase) const {
    return std::size_t((phase.z() * phases + phase.y()) * phases + phase.x());
  }
};

// The stencil of a refinement, made at first use. refine: 1 to 4.
const FieldStencil& fieldStencil(int refine);

// Evaluates planes of a brick's 64 nodes into `out`: plane z if bit z of `planes` is set, z from 0
// to 3. low: the lowest cell that the brick's nodes reach, one below the cell of the brick's first
// node along each axis. alongY, alongZ: distances between neighbouring cells, in floats. Reads up
// to 6 cells from `low` on along each axis. The results have the same bits whichever planes are
// asked for, with any instruction set.
void sumBrick(const FieldStencil& stencil, const Vec3i& phase, const float* low,
              std::ptrdiff_t alongY, std::ptrdiff_t alongZ, unsigned planes, float* out);

// The same for cells stored as levels (sph/colour_values.h), with the same bits; alongY and alongZ
// are in cells. Reads up to 16 cells along x. sumBrick() uses AVX2 where the machine has it;
// sumBrickPlainly() is for comparison.
void sumBrick(const FieldStencil& stencil, const Vec3i& phase, const std::uint8_t* low,
              std::ptrdiff_t alongY, std::ptrdiff_t alongZ, unsigned planes, float* out);

void sumBrickPlainly(const FieldStencil& stencil, const Vec3i& phase, const std::uint8_t* low,
                     std::ptrdiff_t alongY, std::ptrdiff_t alongZ, unsigned planes, float* out);

}  // namespace resect
