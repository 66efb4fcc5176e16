// Which chunks of cells can be in a place now? So that whoever looks for cells near something asks
// sixteen at a time first.
#pragma once

#include "geometry/aabb.h"
#include "tissue/elastic/elastic_state.h"

namespace resect {

// Bounds of the centres of the chunk's solid cells where they are now, m; `origin`: of the cell
// (0, 0, 0) at rest. May be larger than need be, never smaller.
Aabb chunkBounds(const ElasticState& state, const TissueChunk& chunk, const Vec3& origin);

// At least the speed of its fastest cell, m/s.
double chunkSpeed(const ElasticState& state, const TissueChunk& chunk);

}  // namespace resect
