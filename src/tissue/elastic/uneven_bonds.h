// Correction of the forces in uneven bonds. A bond connects two neighbouring cells. It is uneven if
// the cells have different penalty stiffnesses kappa (docs/methods/tissue.md). This occurs between
// two materials, and beside a cell without a deformation gradient, whose kappa is 0.
//
// The stress pass computes the force on a cell with the cell's own kappa for all of its bonds, so
// that one sum is enough. The forces in the few uneven bonds are corrected afterwards.
#pragma once

#include <span>
#include <vector>

#include "tissue/elastic/elastic_state.h"

namespace resect {

struct UnevenBond {
  std::int32_t a, b;  // its two cells: indices in ElasticState::box
  // w (kappa_b - kappa_a) / spacing^2, N/m. w: weight of the bond, from bondWeights().
  float stiffness;
};

// All uneven bonds, in ascending order of a. Cost: some ns per cell of the chunks that are marked
// as uneven (TissueChunk::uneven).
std::vector<UnevenBond> findUnevenBonds(const ElasticState& state);

// Adds the corrections to ElasticState::bondForce. Call after the stress pass.
void pullUnevenBonds(std::span<const UnevenBond> bonds, ElasticState& state);

}  // namespace resect
