// Bounds of the present positions and speeds of a chunk's cells, to reject sixteen cells at a time
// in searches.
#pragma once

#include "geometry/aabb.h"
#include "tissue/elastic/elastic_state.h"

namespace resect {

// Bounds of the present centres of the chunk's solid cells, m; `origin`: rest position of cell (0,
// 0, 0). Conservative: may be too large, never too small.
Aabb chunkBounds(const ElasticState& state, const TissueChunk& chunk, const Vec3& origin);

// Upper bound of the speed of its cells, m/s.
double chunkSpeed(const ElasticState& state, const TissueChunk& chunk);

}  // namespace resect
