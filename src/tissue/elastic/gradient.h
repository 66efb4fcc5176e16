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

// F - I, where F is the deformation gradient; zero for a cell without a gradient.
Mat3 gradientAt(const ElasticState& state, std::int32_t cell);

// As gradientAt(), but in single precision and fast for many cells. at() computes the gradients of
// all cells of a chunk (sixteen cells of a row) together, and keeps them until it is called for
// another chunk. The state must not change as long as this object is used.
class ChunkGradients {
 public:
  ChunkGradients(const ElasticState& state, const ElasticKernel& kernel);
  Mat3 at(std::int32_t cell);

 private:
  const ElasticKernel& kernel_;
  ElasticView view_;
  float weight_[4];  // argument of ElasticKernel::placements
  std::int32_t start_ = -1;
  float found_[12][kChunk];
};

// Elastic energy per volume at rest, J/m^3, that the cell has with the deformation gradient f. It
// is the sum of heldEnergy() (tissue/material.h) and of the energy of the Maxwell branches in their
// present state.
double freeEnergy(const ElasticState& state, std::int32_t cell, const Mat3& f);

// cof F, the cofactor matrix of F. It maps area vectors at rest to present area vectors.
Mat3 cofactors(const Mat3& f);

}  // namespace resect
