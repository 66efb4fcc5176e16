// The deformation gradients of cells.
#pragma once

#include "tissue/elastic/elastic_state.h"
#include "tissue/elastic/kernel/elastic_kernel.h"

namespace resect {

// Cells are given by their index in the CellBox.

// Weights of neighbours by kind (tissue/stencil.h), in units of an edge neighbour's weight. The
// arrays of ElasticState are made for this unit.
std::array<double, 4> edgeWeights();

// ElasticState::inverseMoment of a cell as a matrix, 1/m.
Mat3 inverseMomentAt(const ElasticState& state, std::int32_t cell);

// F - I, with the deformation gradient F; zero for a cell without one.
Mat3 gradientAt(const ElasticState& state, std::int32_t cell);

// As gradientAt(), in single precision and for many cells: at() computes all cells of a chunk
// together, and keeps them until it is called for another chunk. The state must not change
// meanwhile.
class ChunkGradients {
 public:
  ChunkGradients(const ElasticState& state, const ElasticKernel& kernel);
  Mat3 at(std::int32_t cell);

 private:
  const ElasticKernel& kernel_;
  ElasticView view_;
  float weight_[4];  // of neighbours, as ElasticKernel::placements takes them
  std::int32_t start_ = -1;
  float found_[12][kChunk];
};

// Elastic energy, per volume at rest, of the cell with the deformation gradient f, J/m^3:
// heldEnergy() and the energy of the Maxwell branches in their present state.
double freeEnergy(const ElasticState& state, std::int32_t cell, const Mat3& f);

// cof F, the cofactor matrix: it maps area vectors at rest to present ones.
Mat3 cofactors(const Mat3& f);

}  // namespace resect
