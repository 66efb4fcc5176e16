// Labels of an organ's cells. A label is the number of the structure, such as a tumour, to which a
// cell belongs. The functions give a label to the cells in a region, and copy labels to another
// discretisation of the same organ.
#pragma once

#include <array>
#include <cstdint>

#include "sph/discretization.h"

namespace resect {

// Gives the label (0 to 255) to the particles in the region, and returns their number. A particle
// is a cell whose centre lies inside the organ. The region must be placed (organ/region_placer.h).
// Call labelSkin() after the last region; until then the labels of skin cells (see below) are
// wrong. Cost: a pass over the cells.
std::int64_t markCells(Discretization& cells, int label, const Region& region);

// Gives each skin cell the label of the particle that it belongs to. A skin cell holds tissue
// although its centre lies outside the organ (organ/organ.h).
void labelSkin(Discretization& cells);

// Number of particles of each label.
std::array<std::int64_t, 256> labelledParticles(const Discretization& cells);

// Copies the labels, the names of the labels, and the landmarks to another discretisation of the
// same organ. A particle of `to` gets the label of the cell of `from` in which the particle's
// centre lies. Then labelSkin() is called for `to`.
void carryLabels(const Discretization& from, Discretization& to);

}  // namespace resect
