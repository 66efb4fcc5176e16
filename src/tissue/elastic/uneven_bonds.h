// Correction of bonds between cells of different penalty stiffness: of two materials, or of which
// one cell has no deformation gradient.
//
// The stress pass uses a cell's own kappa for both ends of its bonds, so that it needs one sum
// only; these few bonds are corrected afterwards.
#pragma once

#include <span>
#include <vector>

#include "tissue/elastic/elastic_state.h"

namespace resect {

struct UnevenBond {
  std::int32_t a, b;  // cells of the box
  float stiffness;    // w (kappa_b - kappa_a) / spacing^2, N/m
};

// All of them, in ascending order. Cost: some ns per cell of the chunks that have one.
std::vector<UnevenBond> findUnevenBonds(const ElasticState& state);

// Adds the difference to the bond forces of the stress pass.
void pullUnevenBonds(std::span<const UnevenBond> bonds, ElasticState& state);

}  // namespace resect
