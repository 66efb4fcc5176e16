// Labels of the surface's vertices: each vertex has the label of the particle nearest to it at
// rest.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "organ/organ.h"

namespace resect {

// The remaining particle whose cell centre is nearest to a point of rest space; among equals the
// first in the lattice; -1 if there is none within two cells along each axis. alive: as in Organ.
std::int64_t nearestParticle(const Lattice& lattice, std::span<const std::uint8_t> alive,
                             const Vec3& point);

// One label per vertex of organ.surface.points(); the surface must be up to date. Holes, which no
// triangle uses, have 0. Beside an incision the label is that of the particle with the greatest
// weight in the vertex's binding, which lies on the vertex's own side (wound/vertex_binding.h). For
// an organ that was made without labels all are 0, even if edits have set labels since. Cost: 27 to
// 125 cells per vertex.
std::vector<std::uint8_t> vertexLabels(const Organ& organ);

}  // namespace resect
