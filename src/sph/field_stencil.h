// Stencils of the colour field: the weights of the cells in reach of a node, and their sums for a
// brick.
//
// The rest lattice is regular, so nodes at the same position within their cells have the same
// weights. With one or two nodes a cell every node lies on a cell centre or midway between two,
// along each axis. Cells mirrored about the node then have equal weights: their values are added
// first, axis by axis, which leaves four to eight products a node instead of up to 36. Other
// refinements take the plain sum.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace resect {

constexpr int kBrickNodes = 4;                // along each axis
constexpr int kBrickSize = 64;                // nodes of a brick
constexpr double kSmoothingPerSpacing = 0.8;  // h / spacing: support of exactly two cells

struct FieldStencil {
  // Values for half a plane of a brick's nodes: two rows of four.
  struct alignas(32) HalfPlane : std::array<float, 8> {};
  // The weights of a cell for the nodes of a plane. Nodes differ in their position within their
  // cells, so each has its own weight; 0 where the cell is out of its reach.
  struct Tap {
    std::array<HalfPlane, 2> weight;
    int offset;  // into a table of cells, from the node's own cell less one
  };

  int refine;  // nodes per cell and axis, 1 to 4
  int phases;  // phases of bricks per axis: 3 for refine 3, else 1
  // refine 1 and 2: [node midway in y: 0 or 1][in z][which sums along z, y and x, one bit each, x
  // lowest: 0 the nearest cells, 1 the next ones].
  std::array<std::array<std::array<HalfPlane, 8>, 2>, 2> mirrored;
  std::vector<std::vector<Tap>>
      taps;                 // refine 3 and 4: per position z of the plane, phase y, phase x
  std::vector<float> full;  // the nodes of a brick in solid tissue, per phase

  std::size_t phaseIndex(const Vec3i& phase) const {
    return std::size_t((phase.z() * phases + phase.y()) * phases + phase.x());
  }
};

// Made at first use. refine: 1 to 4.
const FieldStencil& fieldStencil(int refine);

// Evaluates the planes of a brick's 64 nodes named by the low four bits of `planes`, into out. low:
// the lowest cell that the brick's nodes reach, one below that in which its first node lies;
// strides in floats. Reads up to 6 cells from there along each axis. The same bits
// whichever planes are asked for, with any instruction set.
void sumBrick(const FieldStencil& stencil, const Vec3i& phase, const float* low,
              std::ptrdiff_t alongY, std::ptrdiff_t alongZ, unsigned planes, float* out);

// The same for cells stored as levels (sph/colour_values.h), with the same bits; strides in cells.
// Reads up to 16 cells along x. sumBrick uses AVX2 where the machine has it; sumBrickPlainly is for
// comparison.
void sumBrick(const FieldStencil& stencil, const Vec3i& phase, const std::uint8_t* low,
              std::ptrdiff_t alongY, std::ptrdiff_t alongZ, unsigned planes, float* out);

void sumBrickPlainly(const FieldStencil& stencil, const Vec3i& phase, const std::uint8_t* low,
                     std::ptrdiff_t alongY, std::ptrdiff_t alongZ, unsigned planes, float* out);

}  // namespace resect
