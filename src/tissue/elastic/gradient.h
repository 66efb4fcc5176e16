// The deformation gradients of cells.
#pragma once

#include "tissue/elastic/elastic_state.h"
#include "tissue/elastic/kernel/elastic_kernel.h"

namespace resect {

// Cells are given by their index in the CellBox.

// Weights of neighbours by kind (tissue/stencil.h), relative to an edge neighbour's weight: the
// unit that the arrays of ElasticState are made for.
std::array<double, 4> edgeWeights();

// ElasticState::inverseMoment of a cell as a matrix, 1/m.
Mat3 inverseMomentAt(const ElasticState& state, std::int32_t cell);

// H = F - I; zero for a cell without a gradient.
Mat3 gradientAt(const ElasticState& state, std::int32_t cell);

// The same in single precision, for many cells: those of a chunk are found at once.
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

// Elastic energy per volume at rest that the cell holds with gradient F, J/m^3: of the law and of
// the Maxwell branches as they are now.
double freeEnergy(const ElasticState& state, std::int32_t cell, const Mat3& f);

// cof F: it turns normals and scales areas.
Mat3 cofactors(const Mat3& f);

}  // namespace resect
