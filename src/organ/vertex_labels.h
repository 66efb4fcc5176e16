// Which structure does each vertex of the surface show? The label of the particle that it lies on,
// at rest.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "organ/organ.h"

namespace resect {

// The particle that is left whose cell's centre is nearest to a point of rest space, of several the
// first in the lattice; -1 when there is none within two cells along each axis. alive: as Organ's.
std::int64_t nearestParticle(const Lattice& lattice, std::span<const std::uint8_t> alive,
                             const Vec3& point);

// One per vertex of organ.surface.points(), for an organ whose surface is up to date; 0 for holes,
// which no triangle uses. Beside an incision it is the particle on the vertex's own side that
// counts most for its motion (wound/vertex_binding.h). Cost: 27 to 125 cells looked at per
// vertex; nothing for an organ without labels but the zeros.
std::vector<std::uint8_t> vertexLabels(const Organ& organ);

}  // namespace resect
