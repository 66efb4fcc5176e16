// Labels of the surface's vertices. Away from incisions a vertex has the label of the particle that
// is nearest to it at rest.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "organ/organ.h"

namespace resect {

// Of the particles that are left, the one whose cell centre is nearest to a point of rest space. If
// several are equally near, the first of these in the lattice. Only cells that are at most two
// cells away, along each axis, from the cell that contains the point are searched. -1 if no
// particle is left in these cells. alive: as in Organ.
std::int64_t nearestParticle(const Lattice& lattice, std::span<const std::uint8_t> alive,
                             const Vec3& point);

// One label per vertex of organ.surface.points(); the surface must be up to date. A vertex beside
// an incision has the label of the particle with the greatest weight in the vertex's binding; this
// particle is on the vertex's own side of the incision (wound/vertex_binding.h). Holes in the
// arrays (vertices that no triangle uses) and vertices for which nearestParticle() returns -1 have
// label 0. In an organ that was made without labels all vertices have label 0, even if edits have
// set labels since. Cost: 27 cells are examined per vertex, and 125 more if none of them holds
// tissue.
std::vector<std::uint8_t> vertexLabels(const Organ& organ);

}  // namespace resect
