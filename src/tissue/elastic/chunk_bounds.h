// Bounds of the present positions and of the speeds of a chunk's cells. A chunk is a group of
// sixteen cells in a row of the lattice. With these bounds, a search can reject all sixteen cells
// of a chunk at once.
#pragma once

#include "geometry/aabb.h"
#include "tissue/elastic/elastic_state.h"

namespace resect {

// A box that contains the present centres of the chunk's solid cells, m. It may be larger than
// needed. origin: rest position of the centre of cell (0, 0, 0), m.
Aabb chunkBounds(const ElasticState& state, const TissueChunk& chunk, const Vec3& origin);

// Upper bound of the speed of the chunk's cells, m/s.
double chunkSpeed(const ElasticState& state, const TissueChunk& chunk);

}  // namespace resect
