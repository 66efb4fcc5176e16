// The state of elastic tissue between two substeps, as arrays over the cells of a padded box.
//
// Bytes per cell of the box: 4 * (3 * 4 + 9 + 6 + 3 * 3 + 5) + 4 = 168. Lengths are in m, masses in
// kg; offsets to neighbours are counted in spacings. Letters are those of docs/methods/tissue.md:
// A_i, q_i, L_i for the inverse of M_i, and S_i for the sum of w_ij X_ij. w is the weight of an
// edge neighbour (bondWeights()). Weights in sums are in units of w; the remaining factors are
// folded into the arrays.
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
  // Some cell is held or loaded.
  bool steered = false;
  // Some cell has no deformation gradient, or a bond to a cell of another stiffness.
  bool uneven = false;
  // No bond of these cells is severed: every solid neighbour is bonded.
  bool whole = true;
  // For each half of the chunk: all its cells are solid and have all 26 bonds.
  bool full[2] = {false, false};
  std::int8_t first = kChunk, last = -1;  // first and last solid cell, from `start` on
};

struct ElasticState {
  CellBox box;
  double spacing = 0;  // m
  double penalty = 0;  // alpha
  std::vector<TissueMaterial> materials;
  std::array<FloatArray, 3> u, ahead, v;    // displacement, m; u + beta dt v, m; velocity, m/s
  std::array<FloatArray, 9> stress;         // A w / spacing, row by row, N
  std::array<FloatArray, 3> bondForce;      // q, N
  std::array<FloatArray, 6> inverseMoment;  // L w / spacing: xx yy zz xy xz yz, 1/m
  std::array<FloatArray, 3> skew;           // S / w, in spacings
  // Weights of the nine cells of a plane across the row, in units of w, as the cells before and
  // after the plane in the row see them. Cells that are not solid do not count; the plane's middle
  // cell may be one of these. [0]: sum of the weights. [1], [2]: sum of the weights times the
  // offsets from the middle cell along y and z.
  std::array<FloatArray, 3> planeWeight;
  std::array<FloatArray, 3> load;              // outside force on the cell, N
  FloatArray inverseMass;                      // 1/kg, 0 where no cell is
  FloatArray shearVolume, lameVolume;          // mu V and (lambda + mu) V, J; V: cell's volume
  FloatArray kappa;                            // alpha mu V, J; 0 for a cell without gradient
  AlignedArray<std::uint32_t> bonds;           // bit d: bonded to the neighbour in direction d
  AlignedArray<std::uint8_t> solid, material;  // material: index into materials
  AlignedArray<std::uint8_t> held, loaded;     // held: HeldAxis bits; loaded: `load` counts
  std::vector<TissueChunk> chunks;             // ascending

  template <class Visitor>
  void visit(Visitor& v) {
    const CellOrder order = box.order();
    v.perCell("u", u, order), v.perCell("v", this->v, order);
    v.perCell("solid", solid, order), v.perCell("material", material, order);
    v.perCell("bonds", bonds, order);
    v.perCell("held", held, order), v.perCell("loaded", loaded, order);
    v.perCell("load", load, order);
    v("materials", materials);
  }
  template <class Visitor>
  void visitMade(Visitor& v) {
    v.made(box, spacing, penalty, ahead, stress, bondForce, inverseMoment, skew, planeWeight);
    v.made(inverseMass, shearVolume, lameVolume, kappa, chunks);
  }
};

}  // namespace resect
