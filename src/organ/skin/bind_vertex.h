// Finds the particles that a vertex of the surface follows, away from wounds.
//
// They are the particle nearest to the vertex, and the nearest of those bonded to it. So a vertex
// never follows particles on both sides of a cut. Weights fall to zero with distance, so that
// neighbouring vertices move alike. They do so also at a thin margin, where a vertex follows few
// particles, which all lie on one side of it.
#pragma once

#include "sph/lattice.h"
#include "tissue/tissue_model.h"
#include "wound/vertex_binding.h"

namespace resect {

// vertex: its rest position, m. The first cell of the result is the nearest. If there is no
// particle within about two cells, `count` is 0. The result depends only on the particles round the
// vertex and on the bonds of the first cell.
VertexBinding bindVertex(const Vec3f& vertex, const Lattice& lattice, const TissueModel& tissue);

}  // namespace resect
