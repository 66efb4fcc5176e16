// Labels of the surface's vertices: each has the label of its particle, at rest.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "organ/organ.h"

namespace resect {

// The remaining particle whose cell centre is nearest to a point of rest space, of several the
// first in the lattice; -1 if there is none within two cells along each axis. alive: as in Organ.
std::int64_t nearestParticle(const Lattice& lattice, std::span<const std::uint8_t> alive,
                             const Vec3& point);

// One per vertex of organ.surface.points(), for an organ whose surface is up to date; 0 for holes,
// which no triangle uses. Beside an incision it is the particle of greatest weight in the vertex's
// binding, which is on its own side (wound/vertex_binding.h). Cost: 27 to 125 cells per vertex; for
// an organ without labels only the zeros.
std::vector<std::uint8_t> vertexLabels(const Organ& organ);

}  // namespace resect
