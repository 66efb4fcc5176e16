// Correction of uneven bonds: those between two cells of different penalty stiffness kappa. The
// cells are of two materials, or one of them has no deformation gradient.
//
// The stress pass uses a cell's own kappa for both ends of each of its bonds, so that it needs one
// sum only. The forces of the few uneven bonds are corrected afterwards.
#pragma once

#include <span>
#include <vector>

#include "tissue/elastic/elastic_state.h"

namespace resect {

struct UnevenBond {
  std::int32_t a, b;  // cells of the box
  float stiffness;    // w (kappa_b - kappa_a) / spacing^2, N/m; w: bondWeights()
};

// All uneven bonds, in ascending order of a. Cost: some ns per cell of the chunks that are marked
// as uneven.
std::vector<UnevenBond> findUnevenBonds(const ElasticState& state);

// Adds the corrections to the bond forces of the stress pass.
void pullUnevenBonds(std::span<const UnevenBond> bonds, ElasticState& state);

}  // namespace resect
