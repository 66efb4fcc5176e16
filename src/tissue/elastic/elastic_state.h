// The state of elastic tissue between two substeps, as arrays over the cells of a box with a halo,
// a border of empty cells.
//
// Memory per cell of the box: 4 * (3 * 4 + 9 + 6 + 3 * 3 + 8) + 6 = 182 bytes. If a material has n
// Maxwell branches, 4 * (7 + 8 n) bytes are added. With a capsule, 24 bytes are added, or 52 if
// there are no branches. Lengths are in m, masses in kg; but offsets to neighbours are in spacings
// (sides of a cell). V is the volume of a cell; lambda and mu are Lame's constants. The symbols
// A_i, q_i and M_i are those of docs/methods/tissue.md. L_i is the inverse of M_i. S_i is the sum
// over the bonded neighbours j of w_ij X_ij, where X_ij is the offset at rest. The symbol w without
// indices is the weight of an edge neighbour, a neighbour that shares an edge with the cell
// (bondWeights()). beta is TissueSettings::damping. The loops over the cells
// (kernel/elastic_kernel.h) form sums in which weights are in units of w and offsets in spacings.
// The arrays contain the missing factors w and 1 / spacing.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tissue/elastic/aligned_array.h"
#include "tissue/elastic/cell_box.h"
#include "tissue/material.h"

namespace resect {

using FloatArray = AlignedArray<float>;

// Bits of ElasticState::held.
enum HeldAxis : std::int32_t { kHeldX = 1, kHeldY = 2, kHeldZ = 4, kHeldAll = 7 };

// Sixteen cells of a row, at least one of them solid.
struct TissueChunk {
  std::int32_t start = 0;  // index in the box, a multiple of kChunk
  // Whether any cell of the chunk has `held` or `loaded` set.
  bool steered = false;
  // Whether any cell of the chunk has no deformation gradient, or is bonded to a cell whose kappa
  // differs from its own.
  bool uneven = false;
  // Whether all cells of the chunk are bonded to all their solid neighbours.
  bool whole = true;
  // Whether any cell of the chunk has a capsule.
  bool skin = false;
  // For each half of the chunk: whether all its cells are solid and have all 26 bonds.
  bool full[2] = {false, false};
  std::int8_t first = kChunk, last = -1;  // first and last solid cell, counted from `start`
};

struct ElasticState {
  CellBox box;
  double spacing = 0;  // m
  double penalty = 0;  // alpha, see TissueSettings::penalty
  std::vector<TissueMaterial> materials;
  std::array<FloatArray, 3> u, ahead, v;    // u: displacement, m; ahead: u + beta dt v, m; v: m/s
  std::array<FloatArray, 9> stress;         // A w / spacing, row by row, N
  std::array<FloatArray, 3> bondForce;      // q, N
  std::array<FloatArray, 6> inverseMoment;  // L w / spacing: xx yy zz xy xz yz, 1/m
  std::array<FloatArray, 3> skew;           // S / w, in spacings
  // Element i describes nine cells: the 3 x 3 cells round cell i in the plane perpendicular to x.
  // Each of these cells has the weight that it has as a neighbour of cell i - 1 or i + 1, in units
  // of w. Only solid cells count. Cell i itself need not be solid. [0]: sum of the weights. [1],
  // [2]: sums of the weights times the offsets from cell i along y and z.
  std::array<FloatArray, 3> planeWeight;
  std::array<FloatArray, 3> load;  // external force on the cell, N
  // relaxed[k]: the symmetric matrix B of Maxwell branch k, as xx yy zz xy xz yz. The stress of the
  // branch is mu share (F (I + B) - cof F), where mu share is the modulus of the branch. viscous:
  // sum over the branches of modulus times V times B, J. In this sum, B is a mean over the substeps
  // until the branches are advanced again. `relaxed` is empty if no material has Maxwell branches.
  // `viscous` is empty if no material has Maxwell branches or a capsule.
  std::array<std::array<FloatArray, 6>, kMostBranches> relaxed;
  std::array<FloatArray, 6> viscous;
  FloatArray inverseMass;  // 1/kg; 0 where there is no tissue
  // share: volume that the cell's stress acts on, as a share of V (stressShares() in
  // boundary_cells.h). weight: weight of the cell over inertia times gravity. It is less
  // than 1 in cells whose share is less than their least inertia (remakeCells()).
  FloatArray share, weight;
  // In these arrays V includes the factor `share`. shearVolume: mu V, J. lameVolume: V (lambda + mu
  // + M / 3), J, where M is the sum of the branches' moduli.
  FloatArray shearVolume, lameVolume;
  FloatArray stiffening;                               // b of tissue/material.h
  FloatArray viscousVolume;                            // M V, J; empty if `viscous` is empty
  std::array<FloatArray, kMostBranches> branchVolume;  // modulus of branch k times V, J
  std::array<FloatArray, kMostBranches> branchRate;    // 1 / relaxation time, 1/s
  // These arrays are empty if no material has a capsule. capsule: Young's modulus times thickness
  // times area of the cell's capsule, J. The area is limited so that substeps stay stable.
  // `capsule` is 0 if the cell has no capsule or its capsule is torn. skinArea: area of the cell's
  // skin, m^2. skinNormal: normal of this skin, unit.
  FloatArray capsule, skinArea;
  std::array<FloatArray, 3> skinNormal;
  // tightness: stretch minus 1 of the cell's capsule in the intact organ, as far as a wound sets it
  // free (retractCapsule()). lips: cells whose capsule ends at a wound, ascending.
  FloatArray tightness;
  std::vector<std::int32_t> lips;
  FloatArray kappa;                            // alpha mu V, J; 0 for a cell without a gradient
  AlignedArray<std::uint32_t> bonds;           // bit d: bonded to the neighbour in direction d
  AlignedArray<std::uint8_t> solid, material;  // 1: solid; index in `materials`
  AlignedArray<std::uint8_t> owner;            // of boundary cells, as in TissueCells; else 0
  AlignedArray<std::uint8_t> capsuleTorn;      // 1: torn
  AlignedArray<std::uint8_t> held, loaded;     // bits of HeldAxis; 1: `load` may be other than 0
  std::vector<TissueChunk> chunks;             // all chunks with solid cells, ascending by `start`

  template <class Visitor>
  void visit(Visitor& v) {
    const CellOrder order = box.order();
    v.perCell("u", u, order), v.perCell("v", this->v, order);
    v.perCell("solid", solid, order), v.perCell("material", material, order);
    v.perCell("bonds", bonds, order);
    v.perCell("held", held, order), v.perCell("loaded", loaded, order);
    v.perCell("load", load, order), v.perCell("capsuleTorn", capsuleTorn, order);
    v("materials", materials);
    constexpr const char* kNames[kMostBranches] = {"relaxed0", "relaxed1", "relaxed2"};
    for (int k = 0; k < kMostBranches; ++k) v.perCell(kNames[k], relaxed[std::size_t(k)], order);
  }
  int branches() const;  // number of Maxwell branches that have arrays
  template <class Visitor>
  void visitMade(Visitor& v) {
    v.made(box, spacing, penalty, ahead, stress, bondForce, inverseMoment, skew, planeWeight);
    v.made(inverseMass, share, weight, shearVolume, lameVolume, kappa, owner, chunks);
    v.made(capsule, skinArea, skinNormal, tightness, lips, stiffening, viscous, viscousVolume,
           branchVolume, branchRate);
  }
};

}  // namespace resect
