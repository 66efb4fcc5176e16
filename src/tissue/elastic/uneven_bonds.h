// Correction of the forces in uneven bonds: bonds between two cells of different penalty stiffness
// kappa. Either the materials of the two cells have different kappa, or one of the cells has no
// deformation gradient and so a kappa of 0.
//
// In the stress pass a cell uses its own kappa for both ends of each of its bonds, so that one sum
// is enough. The forces in the few uneven bonds are corrected afterwards.
#pragma once

#include <span>
#include <vector>

#include "tissue/elastic/elastic_state.h"

namespace resect {

struct UnevenBond {
  std::int32_t a, b;  // its two cells: indices in ElasticState::box
  float stiffness;    // w (kappa_b - kappa_a) / spacing^2, N/m; w: the bond's weight, bondWeights()
};

// All uneven bonds, in ascending order of a. Cost: some ns per cell of the chunks that are marked
// as uneven (TissueChunk::uneven).
std::vector<UnevenBond> findUnevenBonds(const ElasticState& state);

// Adds the corrections to ElasticState::bondForce. Call after the stress pass.
void pullUnevenBonds(std::span<const UnevenBond> bonds, ElasticState& state);

}  // namespace resect
