// Labels of an organ's cells: marking by regions, and transfer to other cells of the same organ.
#pragma once

#include <array>
#include <cstdint>

#include "sph/discretization.h"

namespace resect {

// Gives the label (0 to 255) to the particles in the region and returns their number. The region
// must be placed (sph/region.h). Call labelSkin() afterwards. Cost: a pass over the cells.
std::int64_t markCells(Discretization& cells, int label, const Region& region);

// Gives skin cells the label of the particle that they belong to.
void labelSkin(Discretization& cells);

// Number of particles of each label.
std::array<std::int64_t, 256> labelledParticles(const Discretization& cells);

// Copies labels, their names and landmarks to another discretisation of the same organ. A cell of
// `to` gets the label of the cell of `from` that contains its centre.
void carryLabels(const Discretization& from, Discretization& to);

}  // namespace resect
