// The cells of an organ that elastic tissue is made of.
#pragma once

#include "sph/discretization.h"
#include "tissue/material.h"

namespace resect {

// The organ's particles as solid cells, with the share of tissue of every cell, and the particle
// that each skin cell belongs to (ownerCell() in organ/organ.h). All cells are of `material`.
TissueCells tissueCells(const Discretization& rest, const TissueMaterial& material);

}  // namespace resect
