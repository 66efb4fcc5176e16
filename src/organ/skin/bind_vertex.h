// Which particles a vertex of the surface follows, away from wounds.
//
// The particle nearest to the vertex is chosen, then those bonded to it. So a vertex never follows
// particles of both sides of a cut. Weights fall to nothing with distance: vertices side by side
// move alike, at a thin margin too, where a vertex has few particles, all on one side of it.
#pragma once

#include "sph/lattice.h"
#include "tissue/tissue_model.h"
#include "wound/vertex_binding.h"

namespace resect {

// vertex: at rest, world, m. The first cell of the result is the nearest. If there is no particle
// within about two cells, `count` is 0. The result depends on the particles round the vertex and
// on the bonds of the first cell, on nothing else.
VertexBinding bindVertex(const Vec3f& vertex, const Lattice& lattice, const TissueModel& tissue);

}  // namespace resect
