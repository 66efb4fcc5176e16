// Which structure does each cell of an organ belong to? Marks cells by regions, and carries labels
// over to other cells of the same organ.
#pragma once

#include <array>
#include <cstdint>

#include "sph/discretization.h"

namespace resect {

// Gives the label (0 to 255) to the particles that the placed region holds; returns how many. Skin
// cells follow with labelSkin(). A pass over the cells.
std::int64_t markCells(Discretization& cells, int label, const Region& region);

// Skin cells outside get the label of the particle that they belong to.
void labelSkin(Discretization& cells);

// Particles of each label.
std::array<std::int64_t, 256> labelledParticles(const Discretization& cells);

// Labels, names and landmarks of an organ for another discretisation of it: a cell gets the label
// of the cell that its centre lies in.
void carryLabels(const Discretization& from, Discretization& to);

}  // namespace resect
