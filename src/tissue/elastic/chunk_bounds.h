// Bounds of the present positions and speeds of a chunk's cells. With them a search rejects sixteen
// cells at a time.
#pragma once

#include "geometry/aabb.h"
#include "tissue/elastic/elastic_state.h"

namespace resect {

// A box that contains the present centres of the chunk's solid cells, m. It may be too large, but
// is never too small. origin: rest position of cell (0, 0, 0).
Aabb chunkBounds(const ElasticState& state, const TissueChunk& chunk, const Vec3& origin);

// Upper bound of the speed of the chunk's cells, m/s.
double chunkSpeed(const ElasticState& state, const TissueChunk& chunk);

}  // namespace resect
