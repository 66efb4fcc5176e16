// Carving: an instrument takes away tissue along its path, finer than the cells.
//
// The surface is carved at the nodes of the colour field (sph/node_caps.h). Particles are either
// there or not: a particle goes when less than half of its tissue is left. What is left of it then
// is a remnant. A remnant is drawn, and moves with the particles beside it, but has no mass and
// bears no load. It goes when none of its six neighbouring cells has a particle any more.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "organ/organ.h"

namespace resect {

// Carves the organ's surface along the line. The next updateField() updates the field. Returns the
// particles of which less than half is left now, ascending; the caller must remove them with
// removeCarvedParticle().
std::vector<std::int64_t> carve(Organ& organ, const CarvedLine& line);

// Cap of a node, per cent; 100: it has none, or the node is outside the grid.
float capAt(const Organ& organ, const Vec3i& node);

// Removes the particle in `cell`, as removeParticle() does, but leaves its remnant.
RemovedParticle removeCarvedParticle(Organ& organ, std::int64_t cell);

// Removes the remnants that the removal of these particles has left without a neighbour.
void dropRemnants(Organ& organ, std::span<const std::int64_t> removedCells);

}  // namespace resect
