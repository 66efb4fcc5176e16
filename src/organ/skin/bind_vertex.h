// Finds the particles that a vertex of the surface follows, away from wounds.
//
// A vertex follows the particle that is nearest to it, the first particle, and some particles that
// are bonded to the first particle: those nearest to the vertex, so that it follows at most eight
// particles in all. So a vertex never follows particles on both sides of a cut. The weight of a
// particle falls to zero with its distance from the vertex, so neighbouring vertices move alike.
// This holds even at a thin edge of the organ, where a vertex follows few particles, which all lie
// on one side of the vertex.
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
