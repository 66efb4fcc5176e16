// Stencils of the colour field: the weights of the cells in reach of a node, and the weighted sums
// for the nodes of a brick. A brick has 4 x 4 x 4 nodes (sph/colour_field.h); a plane of a brick
// has 4 x 4 nodes.
//
// The rest lattice is regular, so nodes at the same position within their cells have the same
// weights. With one or two nodes per cell along an axis (refine 1 and 2), every node lies, along
// each axis, at a cell centre or midway between two centres. Cells that are mirror images about the
// node then have equal weights. The values of such cells are added first, one axis after the other;
// the results are called mirrored sums. This leaves four to eight products per node instead of up
// to 36. With refine 3 and 4 each cell's value is multiplied by a weight of its own.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace resect {

constexpr int kBrickNodes = 4;                // nodes of a brick along each axis
constexpr int kBrickSize = 64;                // nodes of a brick in all
constexpr double kSmoothingPerSpacing = 0.8;  // h / spacing; the kernel's radius 2.5 h is two cells

struct FieldStencil {
  // One value for each node of half a plane of a brick: two rows of four nodes.
  struct alignas(32) HalfPlane : std::array<float, 8> {};
  // A tap belongs to one offset, counted in cells from the cell that contains a node. For each of
  // the 16 nodes of a plane, it has the weight of the cell at this offset. Nodes at different
  // positions within their cells have different weights. The weight is 0 if the cell is out of the
  // reach of the node.
  struct Tap {
    std::array<HalfPlane, 2> weight;
    // The offset as an index into CellTable (field_stencil.cpp).
    int offset;
  };

  // Phase of a brick along an axis: position of its first node within the node's cell, from 0 to
  // refine - 1.
  int refine;  // nodes per cell along each axis, 1 to 4
  int phases;  // number of phases that bricks can have along an axis: 3 for refine 3, else 1
  // For refine 1 and 2: weights of the mirrored sums. First index: 1 if the nodes lie midway
  // between cells along y, else 0. Second index: 1 if the nodes lie midway between cells along z,
  // else 0. Third index: number of the mirrored sum, with one bit per axis, x lowest. A bit is 0
  // for the nearest cells along the axis, and 1 for the next cells.
  std::array<std::array<std::array<HalfPlane, 8>, 2>, 2> mirrored;
  // For refine 3 and 4. Index: phaseIndex() of three numbers: the phase of the brick in x, its
  // phase in y, and the position of the plane within its cell in z.
  std::vector<std::vector<Tap>> taps;
  std::vector<float> full;  // for each phaseIndex(): the 64 node values of a brick in solid tissue

  std::size_t phaseIndex(const Vec3i& phase) const {
    return std::size_t((phase.z() * phases + phase.y()) * phases + phase.x());
  }
};

// The stencil of a refinement, 1 to 4. It is made at the first use.
const FieldStencil& fieldStencil(int refine);

// Evaluates planes of a brick's 64 nodes into `out`: plane z, 0 to 3, if bit z of `planes` is set.
// low: points to the value of the lowest cell that the brick's nodes reach. Along each axis, this
// cell is one below the cell of the brick's first node. alongY, alongZ: distances in memory between
// cells that are neighbours along y and z, counted in floats. Reads up to 6 cells along each axis,
// from `low` on. The results have the same bits with any instruction set. The bits of one plane do
// not depend on which other planes are evaluated.
void sumBrick(const FieldStencil& stencil, const Vec3i& phase, const float* low,
              std::ptrdiff_t alongY, std::ptrdiff_t alongZ, unsigned planes, float* out);

// As above, for cells that are stored as levels (sph/colour_values.h). The results have the same
// bits as for floats. alongY and alongZ are counted in cells. Reads up to 16 cells along x. This
// overload uses AVX2 where the machine has it. sumBrickPlainly() computes the same bits without
// AVX2; tests and benchmarks compare the two.
void sumBrick(const FieldStencil& stencil, const Vec3i& phase, const std::uint8_t* low,
              std::ptrdiff_t alongY, std::ptrdiff_t alongZ, unsigned planes, float* out);

void sumBrickPlainly(const FieldStencil& stencil, const Vec3i& phase, const std::uint8_t* low,
                     std::ptrdiff_t alongY, std::ptrdiff_t alongZ, unsigned planes, float* out);

}  // namespace resect
